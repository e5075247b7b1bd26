/** The flight of the program, and what the servos of the model move. */
export const preview = {
  title: 'Flight preview',
  guessed: 'Not to scale.',
  nameServos: 'Name the servos…',
  play: 'Play',
  speed: 'Speed',
  time: 'Time of the flight',
  launch: 'Launch',
  /** After what has happened. */
  at: (time: string) => `at ${time}`,
  sketch: 'The model from the side, and its rudder from above',
  /** Whether the motor runs. */
  motor: { true: 'Climb, motor runs', false: 'Glide, motor stopped' },
  flies: 'In flight',
  comesDown: 'DT: the model comes down',
  duties: {
    rudder: 'Rudder',
    tailplane: 'Tailplane',
    wing: 'Wing',
    release: 'Disc or DT line',
    other: 'Something else',
    none: 'Not used',
  },
  naming: {
    lead: 'What each servo moves, and between which steps. Up and down mean the trailing edge.',
    duty: (servo: string) => `${servo} moves`,
    name: (servo: string) => `Name for what ${servo} moves`,
    low: (servo: string) => `${servo}, one end in steps`,
    high: (servo: string) => `${servo}, other end in steps`,
    from: 'from',
    to: 'to',
    sense: (servo: string) => `${servo}, what more steps do`,
    /** Whether the servo works the other way round. */
    otherSense: { false: 'more steps: up', true: 'more steps: down' },
    rudderSense: { false: 'more steps: right', true: 'more steps: left' },
  },
};
