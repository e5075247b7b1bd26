/** “1 value”, “3 values”. */
export const plural = (count: number, one: string, many: string): string => `${count} ${count === 1 ? one : many}`;
