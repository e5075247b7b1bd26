/** Which memory flies next, and what is known of the others. */
export const nextFlight = {
  badge: 'flies next',
  named: (memory: string) => `${memory}, flies next`,
  other: (memory: string) => `${memory} flies next.`,
  will: (memory: string) => `${memory} will fly next.`,
  /** While there is no connection. */
  last: (memory: string) =>
    `${memory} was current when the timer was heard last: it flies next unless something else has changed it.`,
  home: (home: string) => `At connect it was ${home}.`,
  homeUnknown: 'Which one it was at connect is not known.',
  unknown: 'It is not known which memory flies next.',
  asked: (memory: string) => `${memory} was selected last.`,
  back: (home: string) => `Back to ${home}`,
  leaving: {
    title: 'Before you disconnect',
    back: (home: string) => `Back to ${home} and disconnect`,
    disconnect: 'Disconnect',
    stay: 'Stay connected',
    as: (memory: string) => `${memory} flies next, as at connect.`,
    failed: (home: string) => `It was not possible to go back to ${home}. The timer is still connected.`,
  },
};

/** A memory that is not the current one, by what was last read of it. */
export const look = {
  read: (memory: string, time: string) => `${memory}, read ${time}`,
  notRead: (memory: string) => `${memory} has not been read`,
  uncertain: (memory: string) => `It is not known what ${memory} holds`,
  /** Above the two values that a field may have since a write was cut off. */
  either: 'Either',
  or: 'or',
  /** @param current the memory that flies next. */
  lead: (current: string) => `Shown to be looked at. What you edit and write is ${current}, which flies next.`,
  look: (memory: string) => `Look at ${memory}`,
  hint: (memory: string, current: string) => `Looking selects ${memory}, reads it and goes back to ${current}.`,
  noWayBack: 'This timer does not say which memory is current: nobody could tell which one to go back to.',
  fly: (memory: string) => `Make ${memory} fly next`,
  looking: (memory: string) => `Looking at ${memory}`,
  show: (memory: string) => `Show ${memory}`,
  tableCaption: (memory: string) => `What was read of ${memory}`,
  picture: (memory: string) => `Timeline of ${memory}`,
};
