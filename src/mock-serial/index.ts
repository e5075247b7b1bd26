export const mockserialPlaceholder = 1;
