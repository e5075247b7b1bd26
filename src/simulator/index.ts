export const simulatorPlaceholder = 1;
