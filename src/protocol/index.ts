export const protocolPlaceholder = 1;
