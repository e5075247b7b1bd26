/** How the page looks. */
export const theme = { title: 'Colours', names: { system: 'System', light: 'Light', dark: 'Dark', sun: 'Sun' } };

/** The settings of the page. */
export const settings = {
  look: 'Look',
  expert: 'Expert: show the line',
  expertHint:
    'The line shows every byte between this page and the timer. The bench offers a jump that is not documented.',
  kept: 'What this device keeps',
};
