export const clientPlaceholder = 1;
