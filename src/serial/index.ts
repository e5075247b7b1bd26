export const serialPlaceholder = 1;
