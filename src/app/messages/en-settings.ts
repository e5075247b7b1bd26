/** How the page looks. */
export const theme = { title: 'Colours', names: { system: 'System', light: 'Light', dark: 'Dark', sun: 'Sun' } };
