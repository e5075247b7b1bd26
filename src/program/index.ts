export const programPlaceholder = 1;
