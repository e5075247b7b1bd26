// Made from en.ftl by `npm run sentences`.

type Text = string | number;

export interface PageSentences {
  readonly bench: {
    readonly slots: string;
    readonly elsewhere: (params: { readonly memory: Text }) => string;
    readonly trim: (params: { readonly slot: Text }) => string;
    readonly at: (params: { readonly slot: Text }) => string;
    readonly atNone: string;
    readonly moveMaybe: string;
    readonly unlocked: string;
    readonly unlockMaybe: string;
    readonly jumped: string;
    readonly here: string;
    readonly waits: string;
    readonly bring: (params: { readonly slot: Text }) => string;
    readonly follow: string;
    readonly followHint: string;
    readonly followingNow: string;
    readonly stopFollowing: string;
    readonly ended: {
      readonly over: string;
      readonly memory: string;
      readonly strayed: string;
      readonly unlike: string;
      readonly failed: string;
    };
    readonly notTaken: (params: { readonly field: Text; readonly held: Text; readonly wanted: Text }) => string;
    readonly beside: (params: { readonly more: number; readonly named: Text }) => string;
    readonly triedHere: (params: { readonly more: number; readonly named: Text }) => string;
    readonly triedAndWaiting: (params: { readonly waiting: number; readonly tried: Text }) => string;
    readonly triedIn: (params: { readonly memory: Text }) => string;
    readonly decide: string;
    readonly keep: string;
    readonly putBack: string;
    readonly unlock: string;
    readonly unlockHold: string;
    readonly unlockHint: string;
    readonly experimental: string;
    readonly jumpHint: string;
    readonly jump: string;
    readonly jumpSure: string;
  };
  readonly findings: {
    readonly 'time-not-whole': string;
    readonly 'time-out-of-range': (params: { readonly min: Text; readonly max: Text }) => string;
    readonly 'position-not-whole': string;
    readonly 'position-out-of-range': (params: { readonly min: Text; readonly max: Text }) => string;
    readonly 'throttle-not-whole': string;
    readonly 'throttle-out-of-range': (params: { readonly min: Text; readonly max: Text }) => string;
    readonly 'position-as-read': (params: { readonly value: Text; readonly max: Text }) => string;
    readonly 'time-falls': (params: { readonly previous: Text }) => string;
    readonly 'time-repeats': (params: { readonly previous: Text }) => string;
    readonly 'position-never-reached': (params: { readonly previous: Text }) => string;
    readonly 'motor-stop-after-dt': (params: { readonly dt: Text }) => string;
    readonly 'motor-run-long': (params: { readonly limit: Text }) => string;
    readonly 'time-outside-manual': (params: { readonly min: Text; readonly max: Text }) => string;
    readonly 'time-too-fine': (params: { readonly step: Text }) => string;
    readonly 'dt-short': (params: { readonly limit: Text }) => string;
    readonly 'dt-moves-nothing': string;
    readonly 'throttle-unusual': (params: { readonly limit: Text }) => string;
    readonly 'class-unknown': (params: { readonly timerClass: Text }) => string;
  };
  readonly unreadable: {
    readonly empty: string;
    readonly 'not-a-time': string;
    readonly 'too-fine': string;
    readonly 'not-a-whole-number': string;
    readonly ambiguous: string;
  };
  readonly restWorks: string;
  readonly firstVersions: {
    readonly android: string;
    readonly androidBluetooth: string;
    readonly lastBluetoothOnly: string;
    readonly androidCable: string;
  };
  readonly android: string;
  readonly unsupportedHere: {
    readonly title: string;
    readonly advice: string;
  };
  readonly unsupported: {
    readonly brave: {
      readonly title: string;
      readonly advice: string;
    };
    readonly ios: {
      readonly title: string;
      readonly advice: string;
    };
    readonly android: {
      readonly title: string;
      readonly advice: string;
    };
  };
  readonly edits: {
    readonly redoButton: string;
    readonly undo: (params: { readonly step: Text }) => string;
    readonly redo: (params: { readonly step: Text }) => string;
    readonly steps: {
      readonly change: (params: { readonly what: Text }) => string;
      readonly shift: (params: { readonly what: Text; readonly by: Text }) => string;
      readonly 'step-servo': (params: { readonly what: Text; readonly steps: Text }) => string;
      readonly 'step-servo-from': (params: { readonly what: Text; readonly steps: Text; readonly from: Text }) => string;
      readonly paste: (params: { readonly count: Text }) => string;
      readonly fill: (params: { readonly count: Text }) => string;
      readonly 'revert-all': string;
      readonly open: (params: { readonly what: Text }) => string;
      readonly 'keep-tried': string;
    };
    readonly opened: (params: { readonly name: Text }) => string;
    readonly openedUnnamed: string;
    readonly refused: {
      readonly start: string;
      readonly 'later-out-of-range': (params: { readonly min: Text; readonly max: Text }) => string;
      readonly unreadable: string;
      readonly 'interval-disagrees': string;
      readonly 'no-place': string;
      readonly twice: string;
      readonly 'too-large': (params: { readonly cells: Text }) => string;
    };
    readonly beforeLaunch: string;
    readonly nothingDone: string;
    readonly cells: (params: { readonly count: number }) => string;
    readonly change: (params: { readonly field: Text; readonly from: Text; readonly to: Text }) => string;
    readonly field: {
      readonly putBack: (params: { readonly field: Text }) => string;
      readonly putBackTo: (params: { readonly field: Text; readonly figure: Text }) => string;
    };
    readonly sheet: {
      readonly title: (params: { readonly field: Text }) => string;
      readonly erase: string;
      readonly putBack: string;
      readonly selectRange: string;
      readonly goTo: (params: { readonly name: Text }) => string;
    };
    readonly table: {
      readonly explain: string;
      readonly interval: string;
      readonly countedFrom: (params: { readonly row: Text }) => string;
      readonly switch: string;
      readonly intervalOf: (params: { readonly slot: Text }) => string;
      readonly range: {
        readonly title: string;
        readonly pick: string;
        readonly size: (params: { readonly cells: Text; readonly columns: Text }) => string;
        readonly functions: (params: { readonly count: number }) => string;
        readonly rows: (params: { readonly count: number }) => string;
        readonly columns: (params: { readonly count: number }) => string;
        readonly paste: string;
        readonly fillDown: string;
        readonly clipboardClosed: string;
      };
      readonly tools: (params: { readonly name: Text }) => string;
    };
    readonly stepServo: {
      readonly title: (params: { readonly servo: Text }) => string;
      readonly now: (params: { readonly position: Text }) => string;
      readonly nowRange: (params: { readonly lowest: Text; readonly highest: Text }) => string;
      readonly by: string;
      readonly step: string;
      readonly which: string;
      readonly all: string;
      readonly from: (params: { readonly slot: Text }) => string;
      readonly stops: (params: { readonly count: number; readonly steps: Text; readonly what: Text; readonly at: Text }) => string;
    };
    readonly shift: {
      readonly open: string;
      readonly from: (params: { readonly isLast: boolean; readonly row: Text }) => string;
      readonly by: string;
      readonly earlier: string;
      readonly later: string;
      readonly moveDt: string;
      readonly function: (params: { readonly number: Text }) => string;
      readonly functionRange: (params: { readonly first: Text; readonly last: Text }) => string;
      readonly functions: (params: { readonly numbers: Text }) => string;
      readonly moved: (params: { readonly later: boolean; readonly time: Text }) => string;
    };
    readonly pasting: {
      readonly asks: string;
      readonly choose: string;
      readonly leaveOut: string;
      readonly table: string;
      readonly lead: (params: { readonly count: number }) => string;
      readonly reading: (params: { readonly field: Text; readonly text: Text; readonly time: Text }) => string;
      readonly problems: string;
      readonly place: (params: { readonly row: Text; readonly column: Text }) => string;
      readonly problem: (params: { readonly place: Text; readonly reason: Text }) => string;
      readonly problemOf: (params: { readonly place: Text; readonly text: Text; readonly reason: Text }) => string;
      readonly apply: string;
    };
    readonly presets: {
      readonly title: string;
      readonly use: (params: { readonly time: Text }) => string;
      readonly refused: string;
    };
    readonly fix: (params: { readonly value: Text }) => string;
    readonly fixOf: (params: { readonly value: Text; readonly field: Text }) => string;
  };
  readonly help: {
    readonly title: string;
    readonly steps: {
      readonly programs: string;
      readonly replug: string;
      readonly cable: string;
      readonly windows: string;
      readonly mac: string;
      readonly linux: string;
      readonly 'linux-container': string;
      readonly android: string;
      readonly bluetooth: string;
      readonly 'firefox-finds': string;
      readonly 'firefox-reload': string;
      readonly switch: string;
      readonly near: string;
      readonly battery: string;
      readonly restarts: string;
      readonly 'usual-settings': string;
      readonly report: string;
      readonly address: string;
    };
    readonly page: string;
  };
  readonly keeping: {
    readonly title: string;
    readonly notKept: string;
    readonly notKnown: string;
    readonly oneTab: string;
    readonly emptied: string;
    readonly export: string;
  };
  readonly aside: {
    readonly title: (params: { readonly count: number }) => string;
    readonly write: string;
    readonly save: string;
  };
  readonly counted: {
    readonly models: (params: { readonly count: number }) => string;
    readonly settings: (params: { readonly count: number }) => string;
    readonly flights: (params: { readonly count: number }) => string;
    readonly backups: (params: { readonly count: number }) => string;
  };
  readonly removed: (params: { readonly what: Text }) => string;
  readonly framed: {
    readonly title: string;
    readonly open: string;
  };
  readonly knowledge: {
    readonly title: string;
    readonly uncertain: (params: { readonly memory: Text; readonly values: Text }) => string;
    readonly noFly: string;
    readonly since: (params: { readonly time: Text }) => string;
    readonly thisMemory: string;
    readonly memoryOf: (params: { readonly memory: Text; readonly timer: Text }) => string;
    readonly timer: {
      readonly here: (params: { readonly name: Text; readonly firmware: Text }) => string;
      readonly simulated: (params: { readonly name: Text; readonly firmware: Text }) => string;
    };
    readonly otherTimer: {
      readonly here: (params: { readonly name: Text; readonly firmware: Text }) => string;
      readonly simulated: (params: { readonly name: Text; readonly firmware: Text }) => string;
    };
    readonly motorStop: string;
    readonly either: (params: { readonly name: Text; readonly before: Text; readonly goal: Text }) => string;
    readonly list: (params: { readonly more: number; readonly named: Text }) => string;
    readonly and: (params: { readonly first: Text; readonly next: Text }) => string;
    readonly connect: string;
    readonly forget: string;
    readonly forgetSure: string;
    readonly forgetNow: string;
    readonly verified: (params: { readonly time: Text }) => string;
    readonly readAt: (params: { readonly time: Text }) => string;
    readonly lastReadAt: (params: { readonly time: Text }) => string;
    readonly lastRead: string;
    readonly ofSetting: (params: { readonly changes: number; readonly name: Text }) => string;
    readonly changed: (params: { readonly name: Text }) => string;
    readonly ofModel: (params: { readonly name: Text; readonly model: Text }) => string;
    readonly made: string;
    readonly unknown: (params: { readonly memory: Text }) => string;
    readonly unfinished: (params: { readonly count: number }) => string;
    readonly hints: {
      readonly now: string;
      readonly onceAt: (params: { readonly time: Text }) => string;
      readonly once: string;
    };
    readonly marks: {
      readonly now: (params: { readonly value: Text }) => string;
      readonly once: (params: { readonly value: Text }) => string;
    };
    readonly notCertain: string;
    readonly held: {
      readonly now: string;
      readonly once: string;
    };
  };
  readonly link: {
    readonly portNames: {
      readonly ftdi: string;
      readonly cp210x: string;
      readonly ch340: string;
      readonly pl2303: string;
      readonly bluetooth: string;
      readonly usb: string;
      readonly other: string;
    };
    readonly stages: {
      readonly choosing: string;
      readonly openingLong: {
        readonly title: string;
        readonly advice: string;
      };
      readonly asking: (params: { readonly rate: Text }) => string;
      readonly noAnswer: (params: { readonly seconds: Text }) => string;
      readonly open: string;
      readonly steps: {
        readonly switch: string;
        readonly near: string;
        readonly other: string;
      };
    };
    readonly refused: string;
    readonly heard: {
      readonly title: string;
      readonly advice: string;
    };
    readonly slow: {
      readonly title: string;
      readonly advice: (params: { readonly rate: Text }) => string;
    };
    readonly itSaid: (params: { readonly bytes: Text; readonly text: Text }) => string;
    readonly trySelectBare: string;
    readonly lost: {
      readonly title: string;
      readonly advice: string;
    };
    readonly status: {
      readonly off: string;
      readonly opening: string;
      readonly searching: string;
      readonly away: string;
      readonly closing: string;
    };
  };
  readonly nextFlight: {
    readonly badge: string;
    readonly onScreen: (params: { readonly memory: Text }) => string;
    readonly named: (params: { readonly memory: Text }) => string;
    readonly other: (params: { readonly memory: Text }) => string;
    readonly last: (params: { readonly memory: Text }) => string;
    readonly original: (params: { readonly original: Text }) => string;
    readonly originalUnknown: string;
    readonly unknown: string;
    readonly asked: (params: { readonly memory: Text }) => string;
    readonly back: (params: { readonly original: Text }) => string;
    readonly leaving: {
      readonly title: string;
      readonly back: (params: { readonly original: Text }) => string;
      readonly failed: (params: { readonly original: Text }) => string;
    };
  };
  readonly look: {
    readonly read: (params: { readonly memory: Text; readonly time: Text }) => string;
    readonly notRead: (params: { readonly memory: Text }) => string;
    readonly either: string;
    readonly or: string;
    readonly lead: (params: { readonly current: Text }) => string;
    readonly edit: (params: { readonly memory: Text }) => string;
    readonly look: (params: { readonly memory: Text }) => string;
    readonly hint: (params: { readonly memory: Text; readonly current: Text }) => string;
    readonly fly: (params: { readonly memory: Text }) => string;
    readonly show: (params: { readonly memory: Text }) => string;
  };
  readonly memories: {
    readonly copy: (params: { readonly from: Text; readonly to: Text }) => string;
    readonly restore: string;
    readonly restoreAll: (params: { readonly count: Text }) => string;
    readonly plans: {
      readonly screen: (params: { readonly keepsThrottle: boolean; readonly to: Text }) => string;
      readonly copy: (params: { readonly to: Text; readonly from: Text }) => string;
      readonly restore: (params: { readonly names: Text; readonly time: Text }) => string;
    };
    readonly atEnd: (params: { readonly current: Text }) => string;
    readonly refused: (params: { readonly memory: Text }) => string;
    readonly untouched: (params: { readonly memory: Text }) => string;
    readonly stopped: string;
  };
  readonly byteOrder: {
    readonly title: string;
    readonly advice: string;
    readonly keep: string;
    readonly exchange: string;
  };
  readonly connection: {
    readonly unsupported: {
      readonly title: string;
      readonly advice: string;
    };
    readonly insecure: {
      readonly title: string;
      readonly advice: string;
    };
    readonly policy: {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'nothing-chosen': {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'not-allowed': {
      readonly title: string;
      readonly advice: string;
    };
    readonly busy: {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'bad-settings': {
      readonly title: string;
      readonly advice: string;
    };
    readonly unplugged: {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'bad-reply': {
      readonly title: string;
      readonly advice: string;
    };
    readonly lost: {
      readonly title: string;
      readonly advice: string;
    };
  };
  readonly timer: {
    readonly 'no-answer': {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'bad-reply': {
      readonly title: string;
      readonly advice: string;
    };
    readonly unstable: {
      readonly title: string;
      readonly advice: string;
    };
    readonly crowded: {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'other-memory': {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'memory-unknown': {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'memory-left': {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'other-timer': {
      readonly title: string;
      readonly advice: string;
    };
    readonly stale: {
      readonly title: string;
      readonly advice: string;
    };
    readonly changed: {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'stood-still': {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'too-slow': {
      readonly title: string;
      readonly advice: string;
    };
    readonly undecided: {
      readonly title: string;
      readonly advice: string;
    };
    readonly serious: {
      readonly title: string;
      readonly advice: string;
    };
    readonly busy: {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'port-lost': {
      readonly title: string;
      readonly advice: string;
    };
    readonly aborted: {
      readonly title: string;
      readonly advice: string;
    };
    readonly closed: {
      readonly title: string;
      readonly advice: string;
    };
  };
  readonly alike: {
    readonly title: (params: { readonly request: Text }) => string;
    readonly advice: string;
    readonly part: (params: { readonly values: Text }) => string;
  };
  readonly notes: {
    readonly back: {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'back-uncertain': {
      readonly title: string;
      readonly advice: string;
    };
    readonly moved: {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'timer-moved': {
      readonly title: string;
      readonly advice: string;
    };
    readonly kept: {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'other-kind': {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'write-completed': {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'nothing-written': {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'not-backed-up': {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'select-unanswered': {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'backed-up': {
      readonly title: string;
      readonly advice: string;
    };
    readonly strays: {
      readonly title: string;
      readonly advice: string;
    };
    readonly 'made-laid': {
      readonly title: string;
      readonly advice: string;
    };
    readonly unexpected: {
      readonly title: string;
      readonly advice: string;
    };
  };
  readonly recognition: {
    readonly which: string;
    readonly change: (params: { readonly model: Text }) => string;
  };
  readonly memoryNames: {
    readonly named: (params: { readonly memory: Text; readonly name: Text }) => string;
  };
  readonly recovery: {
    readonly title: string;
    readonly when: (params: { readonly memory: Text; readonly time: Text }) => string;
    readonly nothing: (params: { readonly missing: number }) => string;
    readonly part: (params: { readonly missing: number; readonly values: Text }) => string;
    readonly foreign: (params: { readonly count: number }) => string;
    readonly sure: string;
    readonly finish: string;
    readonly goBack: string;
    readonly leave: string;
    readonly otherTimer: string;
    readonly sameTimer: string;
    readonly compare: string;
    readonly before: string;
    readonly elsewhere: (params: { readonly memory: Text }) => string;
    readonly left: (params: { readonly current: Text; readonly original: Text }) => string;
    readonly mayFly: (params: { readonly memory: Text }) => string;
    readonly mayNotFly: (params: { readonly original: Text }) => string;
    readonly unknownMemory: string;
  };
  readonly backups: {
    readonly title: string;
    readonly empty: string;
    readonly reasons: {
      readonly write: string;
      readonly memories: string;
    };
  };
  readonly shortDt: {
    readonly held: (params: { readonly memory: Text; readonly dt: Text }) => string;
    readonly heldHere: (params: { readonly dt: Text }) => string;
    readonly ask: (params: { readonly remembered: boolean; readonly back: Text }) => string;
    readonly putBack: (params: { readonly remembered: boolean; readonly back: Text }) => string;
    readonly disconnect: (params: { readonly memory: Text; readonly dt: Text }) => string;
    readonly disconnectHere: (params: { readonly dt: Text }) => string;
    readonly blocked: string;
    readonly settings: {
      readonly limit: string;
      readonly hint: string;
    };
  };
  readonly start: {
    readonly title: string;
    readonly lead: string;
    readonly adapter: string;
    readonly firefox: string;
    readonly android: string;
    readonly readyOffline: string;
    readonly install: string;
    readonly picture: {
      readonly example: string;
      readonly kept: (params: { readonly time: Text }) => string;
    };
    readonly models: {
      readonly title: string;
      readonly none: string;
      readonly programs: (params: { readonly count: number }) => string;
      readonly library: string;
    };
    readonly programs: {
      readonly title: string;
      readonly made: (params: { readonly timer: Text }) => string;
      readonly changesOf: (params: { readonly timer: Text }) => string;
      readonly sure: string;
    };
    readonly simulatedTitle: string;
    readonly simulatedLead: string;
    readonly simulated: (params: { readonly name: Text }) => string;
    readonly backups: (params: { readonly count: number; readonly last: Text }) => string;
  };
  readonly newProgram: {
    readonly title: string;
    readonly timerClass: string;
    readonly functions: string;
    readonly servos: string;
    readonly from: string;
    readonly beginnings: {
      readonly usual: string;
      readonly nothing: string;
    };
    readonly caution: string;
    readonly make: string;
  };
  readonly timeline: {
    readonly title: string;
    readonly compareBefore: string;
    readonly picture: string;
    readonly description: (params: { readonly servos: Text; readonly functions: Text; readonly dt: Text }) => string;
    readonly descriptionMotor: (params: { readonly servos: Text; readonly functions: Text; readonly dt: Text; readonly motorStop: Text }) => string;
    readonly functions: (params: { readonly count: number }) => string;
    readonly servos: (params: { readonly count: number }) => string;
    readonly keysToEdit: string;
    readonly ask: string;
    readonly finer: string;
    readonly steps: (params: { readonly position: number }) => string;
    readonly stepsUnit: string;
    readonly notKnown: string;
    readonly tools: string;
    readonly zoomIn: string;
    readonly zoomOut: string;
    readonly fit: string;
    readonly passedOver: (params: { readonly slot: Text; readonly next: Text }) => string;
    readonly goesBack: (params: { readonly next: Text; readonly slot: Text }) => string;
  };
  readonly update: {
    readonly ready: string;
    readonly waits: string;
    readonly take: string;
    readonly news: string;
  };
  readonly views: {
    readonly title: string;
    readonly names: {
      readonly program: string;
      readonly memories: string;
      readonly bench: string;
      readonly library: string;
      readonly line: string;
      readonly settings: string;
      readonly print: string;
      readonly help: string;
    };
    readonly print: string;
    readonly share: string;
    readonly noTimer: {
      readonly memories: string;
      readonly bench: string;
    };
  };
  readonly strip: {
    readonly panel: string;
    readonly tried: (params: { readonly count: number }) => string;
    readonly notCertain: string;
    readonly asRead: string;
    readonly notValid: string;
    readonly ofSetting: (params: { readonly changes: number }) => string;
    readonly made: string;
  };
  readonly palette: {
    readonly title: string;
    readonly search: string;
    readonly nothing: string;
    readonly ctrl: (params: { readonly key: Text }) => string;
  };
  readonly parts: {
    readonly coming: string;
    readonly failed: string;
    readonly again: string;
  };
  readonly write: {
    readonly title: string;
    readonly lead: (params: { readonly memory: Text }) => string;
    readonly target: string;
    readonly nothing: string;
    readonly field: string;
    readonly from: string;
    readonly to: string;
    readonly wasRead: string;
    readonly moved: {
      readonly model: {
        readonly title: string;
        readonly advice: string;
      };
      readonly edits: {
        readonly title: string;
      };
    };
    readonly unkept: {
      readonly title: string;
      readonly advice: string;
    };
    readonly sideBySide: (params: { readonly names: Text }) => string;
    readonly withoutCopy: string;
    readonly safety: string;
    readonly acknowledge: string;
    readonly stillToTick: (params: { readonly ticks: Text }) => string;
    readonly ticks: {
      readonly model: string;
      readonly warnings: string;
      readonly safety: string;
    };
    readonly move: {
      readonly why: string;
      readonly label: string;
      readonly hint: string;
      readonly notHeld: {
        readonly title: string;
        readonly advice: string;
      };
      readonly again: string;
    };
    readonly start: (params: { readonly count: number }) => string;
    readonly stages: {
      readonly read: string;
      readonly write: string;
      readonly verify: string;
      readonly repair: string;
    };
    readonly stopping: string;
    readonly stoppingBack: string;
    readonly verified: {
      readonly title: string;
      readonly advice: string;
    };
    readonly verdict: (params: { readonly memory: Text; readonly time: Text }) => string;
    readonly asItIs: string;
    readonly insteadOf: (params: { readonly value: Text }) => string;
    readonly wanted: string;
    readonly readBack: string;
    readonly differs: {
      readonly title: string;
      readonly advice: string;
    };
    readonly unknown: {
      readonly title: string;
      readonly advice: string;
    };
    readonly cut: (params: { readonly memory: Text }) => string;
    readonly strayed: {
      readonly title: (params: { readonly memory: Text }) => string;
      readonly advice: (params: { readonly memory: Text }) => string;
    };
    readonly refused: string;
    readonly status: {
      readonly differs: string;
      readonly unknown: string;
    };
    readonly putBack: string;
  };
  readonly name: string;
  readonly classNames: {
    readonly Q: string;
    readonly B: string;
    readonly E: string;
  };
  readonly unknownClass: (params: { readonly letter: Text }) => string;
  readonly memoryName: (params: { readonly number: Text }) => string;
  readonly servoName: (params: { readonly number: Text }) => string;
  readonly slotName: (params: { readonly kind: 'dt' | 'function' | 'start'; readonly slot: Text }) => string;
  readonly within: {
    readonly slot: (params: { readonly kind: 'dt' | 'function' | 'start'; readonly slot: Text }) => string;
    readonly idleThrottle: string;
  };
  readonly slotShort: (params: { readonly kind: 'dt' | 'function' | 'start'; readonly slot: Text }) => string;
  readonly about: (params: { readonly name: Text }) => string;
  readonly previous: string;
  readonly next: string;
  readonly pause: string;
  readonly less: (params: { readonly what: Text }) => string;
  readonly moreOf: (params: { readonly what: Text }) => string;
  readonly seconds: (params: { readonly time: Text }) => string;
  readonly times: {
    readonly minutes: (params: { readonly minutes: Text }) => string;
    readonly minutesSeconds: (params: { readonly minutes: Text; readonly seconds: Text }) => string;
    readonly units: {
      readonly s: string;
      readonly min: string;
    };
    readonly figure: (params: { readonly text: Text; readonly unit: Text }) => string;
    readonly asSeconds: (params: { readonly seconds: Text; readonly clock: Text }) => string;
    readonly meaning: (params: { readonly field: Text }) => string;
  };
  readonly header: {
    readonly firmware: (params: { readonly firmware: Text }) => string;
    readonly simulated: string;
    readonly connect: string;
    readonly choosePort: string;
    readonly closeProgram: string;
    readonly disconnect: string;
    readonly stop: string;
  };
  readonly program: {
    readonly tableCaption: string;
    readonly slot: string;
    readonly time: string;
    readonly memory: string;
    readonly memoryUnknown: string;
    readonly memoryOpen: string;
    readonly dt: string;
    readonly motorStop: string;
    readonly motor: string;
    readonly idleThrottle: string;
    readonly throttle: string;
    readonly idleThrottleUnit: string;
    readonly reserved: (params: { readonly time: Text }) => string;
    readonly timeOf: (params: { readonly slot: Text }) => string;
    readonly motorStopTime: string;
    readonly positionOf: (params: { readonly slot: Text; readonly servo: Text }) => string;
    readonly shortDt: string;
    readonly changes: (params: { readonly count: number }) => string;
    readonly undoAll: string;
    readonly read: string;
    readonly connectAndWrite: string;
    readonly write: (params: { readonly count: number }) => string;
    readonly picture: string;
    readonly table: string;
    readonly blocked: (params: { readonly field: Text; readonly why: Text }) => string;
    readonly findings: string;
    readonly noFindings: string;
    readonly absolute: string;
    readonly severity: {
      readonly error: string;
      readonly serious: string;
      readonly warning: string;
    };
    readonly reading: string;
    readonly selecting: string;
  };
  readonly otherTab: {
    readonly holdsSince: (params: { readonly since: Text }) => string;
    readonly holds: string;
    readonly takeOver: string;
    readonly busy: string;
    readonly gone: string;
  };
  readonly disturbed: (params: { readonly seconds: Text }) => string;
  readonly cancel: string;
  readonly close: string;
  readonly copy: string;
  readonly copied: string;
  readonly copyByHand: string;
  readonly dismiss: string;
  readonly done: string;
  readonly undo: string;
  readonly open: string;
  readonly save: string;
  readonly delete: string;
  readonly notNow: string;
  readonly label: {
    readonly language: string;
    readonly name: string;
    readonly note: string;
    readonly model: string;
    readonly search: string;
  };
  readonly noModel: string;
  readonly more: (params: { readonly count: number }) => string;
  readonly showMore: (params: { readonly count: number }) => string;
  readonly of: (params: { readonly button: Text; readonly name: Text }) => string;
  readonly notFitting: string;
  readonly notKept: string;
}

export interface FirstSentences {
  readonly first: {
    readonly failed: string;
    readonly again: string;
  };
}

export interface ManifestSentences {
  readonly manifest: {
    readonly description: string;
    readonly connect: string;
    readonly connectShort: string;
    readonly connectWhat: string;
    readonly library: string;
    readonly libraryWhat: string;
    readonly simulated: string;
    readonly simulatedWhat: string;
    readonly pictures: {
      readonly program: string;
      readonly write: string;
      readonly programPhone: string;
      readonly writePhone: string;
    };
  };
}

export interface MoreSentences {
  readonly flights: {
    readonly title: string;
    readonly empty: {
      readonly title: string;
      readonly advice: string;
    };
    readonly failed: string;
    readonly flying: {
      readonly button: string;
      readonly purpose: string;
      readonly logged: (params: { readonly time: Text }) => string;
      readonly fillIn: string;
      readonly again: string;
    };
    readonly row: {
      readonly round: (params: { readonly round: Text }) => string;
      readonly wind: (params: { readonly wind: Text }) => string;
      readonly temperature: (params: { readonly degrees: Text }) => string;
      readonly noResult: string;
      readonly changed: (params: { readonly values: Text }) => string;
      readonly otherTimer: string;
    };
    readonly totals: {
      readonly flights: (params: { readonly count: number }) => string;
      readonly best: (params: { readonly time: Text }) => string;
      readonly average: (params: { readonly time: Text }) => string;
    };
    readonly filter: {
      readonly of: (params: { readonly name: Text }) => string;
      readonly clear: string;
    };
    readonly form: {
      readonly title: string;
      readonly result: string;
      readonly resultHint: string;
      readonly readAs: (params: { readonly time: Text; readonly seconds: Text }) => string;
      readonly propose: (params: { readonly facts: Text }) => string;
      readonly full: string;
      readonly round: string;
      readonly flyOff: string;
      readonly wind: string;
      readonly windUnit: string;
      readonly temperature: string;
      readonly temperatureUnit: string;
      readonly when: string;
      readonly date: string;
      readonly noOffset: string;
      readonly place: string;
      readonly flown: string;
      readonly open: string;
      readonly unreadable: {
        readonly 'not-a-number': string;
        readonly 'not-a-time': string;
        readonly 'too-fine': string;
      };
      readonly range: (params: { readonly min: Text; readonly max: Text; readonly unit: Text }) => string;
      readonly shortDt: (params: { readonly dt: Text }) => string;
    };
    readonly score: {
      readonly open: string;
      readonly maximum: string;
      readonly none: string;
      readonly maximumOf: (params: { readonly round: Text }) => string;
      readonly counted: string;
      readonly notCounted: string;
      readonly count: string;
      readonly noRound: string;
      readonly total: string;
      readonly copy: string;
    };
    readonly csv: {
      readonly save: string;
      readonly columns: {
        readonly date: string;
        readonly time: string;
        readonly zone: string;
        readonly place: string;
        readonly model: string;
        readonly setting: string;
        readonly timerClass: string;
        readonly memory: string;
        readonly dt: string;
        readonly motorStop: string;
        readonly wind: string;
        readonly temperature: string;
        readonly round: string;
        readonly result: string;
        readonly maximum: string;
        readonly note: string;
      };
    };
    readonly section: {
      readonly all: string;
    };
  };
  readonly versions: {
    readonly title: string;
    readonly until: (params: { readonly when: Text }) => string;
    readonly changed: (params: { readonly more: number; readonly change: Text }) => string;
    readonly otherLayout: string;
    readonly same: string;
    readonly goBack: string;
  };
  readonly compare: {
    readonly title: string;
    readonly open: string;
    readonly second: string;
    readonly screen: string;
    readonly timer: (params: { readonly memory: Text }) => string;
    readonly groups: {
      readonly now: string;
      readonly settings: string;
    };
    readonly setting: (params: { readonly model: Text; readonly name: Text }) => string;
    readonly backup: (params: { readonly memory: Text; readonly when: Text }) => string;
    readonly backupOf: (params: { readonly model: Text; readonly memory: Text; readonly when: Text }) => string;
    readonly nothing: string;
    readonly take: string;
    readonly takeOf: (params: { readonly value: Text; readonly field: Text }) => string;
    readonly takeHint: string;
  };
  readonly modelBackups: {
    readonly same: (params: { readonly when: Text }) => string;
    readonly differs: (params: { readonly count: number; readonly when: Text }) => string;
    readonly now: string;
  };
  readonly files: {
    readonly export: {
      readonly all: string;
      readonly one: string;
      readonly downloaded: (params: { readonly name: Text; readonly what: Text }) => string;
      readonly without: (params: { readonly kind: Text }) => string;
      readonly kinds: {
        readonly models: string;
        readonly settings: string;
        readonly flights: string;
      };
      readonly partly: (params: { readonly name: Text; readonly what: Text; readonly missing: Text }) => string;
      readonly and: (params: { readonly first: Text; readonly next: Text }) => string;
      readonly tooLarge: string;
      readonly failed: string;
    };
    readonly import: {
      readonly button: string;
      readonly title: (params: { readonly name: Text }) => string;
      readonly lead: (params: { readonly date: Text; readonly what: Text }) => string;
      readonly leadNothing: (params: { readonly date: Text }) => string;
      readonly ignored: (params: { readonly count: number }) => string;
      readonly nothing: string;
      readonly differs: string;
      readonly ways: {
        readonly newer: string;
        readonly both: string;
      };
      readonly itself: string;
      readonly flightOf: (params: { readonly day: Text }) => string;
      readonly wayText: {
        readonly newer: string;
        readonly both: string;
      };
      readonly unknownModel: string;
      readonly group: {
        readonly fresh: (params: { readonly what: Text }) => string;
        readonly same: (params: { readonly what: Text }) => string;
        readonly fileNewer: (params: { readonly what: Text }) => string;
        readonly deviceNewer: (params: { readonly what: Text }) => string;
        readonly fileName: (params: { readonly file: Text; readonly here: Text }) => string;
      };
      readonly take: (params: { readonly count: number }) => string;
      readonly allStays: string;
      readonly done: (params: { readonly name: Text; readonly what: Text }) => string;
      readonly undo: string;
      readonly undone: string;
    };
    readonly refused: {
      readonly title: (params: { readonly name: Text }) => string;
      readonly nothing: string;
      readonly again: string;
      readonly fault: (params: { readonly line: Text; readonly found: Text }) => string;
      readonly faultIn: (params: { readonly line: Text; readonly place: Text; readonly found: Text }) => string;
      readonly wanted: string;
      readonly place: {
        readonly entry: (params: { readonly kind: 'flights' | 'models' | 'settings'; readonly name: Text }) => string;
        readonly unnamed: (params: { readonly kind: 'flights' | 'models' | 'settings'; readonly number: Text }) => string;
        readonly function: (params: { readonly number: Text }) => string;
      };
      readonly damaged: string;
      readonly files: {
        readonly 'too-large': string;
        readonly gone: string;
        readonly several: string;
      };
      readonly format: string;
      readonly newer: string;
    };
    readonly reminder: (params: { readonly changes: number }) => string;
  };
  readonly guide: {
    readonly pages: {
      readonly checklist: string;
      readonly trouble: string;
      readonly words: string;
      readonly steps: string;
    };
    readonly nav: string;
  };
  readonly firstSteps: {
    readonly '1': string;
    readonly '2': string;
    readonly '3': string;
  };
  readonly values: {
    readonly function: {
      readonly text: string;
      readonly range: string;
    };
    readonly time: {
      readonly text: string;
      readonly range: string;
    };
    readonly after: {
      readonly text: string;
    };
    readonly position: {
      readonly name: string;
      readonly text: string;
      readonly range: string;
    };
    readonly motorStop: {
      readonly text: string;
      readonly range: string;
    };
    readonly dt: {
      readonly text: string;
      readonly range: string;
    };
    readonly idleThrottle: {
      readonly text: string;
      readonly range: string;
    };
    readonly memory: {
      readonly text: string;
      readonly range: string;
    };
  };
  readonly checklist: {
    readonly lead: string;
    readonly items: {
      readonly memory: string;
      readonly dtTime: string;
      readonly surfaces: string;
      readonly battery: string;
      readonly dtSeen: string;
      readonly radioDt: string;
      readonly switch: string;
      readonly propeller: string;
    };
    readonly known: {
      readonly now: (params: { readonly memory: Text; readonly dt: Text; readonly time: Text }) => string;
      readonly onceAt: (params: { readonly time: Text; readonly memory: Text; readonly dt: Text }) => string;
      readonly once: (params: { readonly memory: Text; readonly dt: Text }) => string;
      readonly not: (params: { readonly memory: Text }) => string;
      readonly nothing: string;
      readonly unwritten: (params: { readonly count: number }) => string;
    };
    readonly left: (params: { readonly count: number }) => string;
    readonly done: string;
    readonly again: string;
  };
  readonly troubles: {
    readonly symptoms: {
      readonly noAnswer: {
        readonly title: string;
      };
      readonly noAdapter: {
        readonly title: string;
      };
      readonly refused: {
        readonly title: string;
      };
      readonly wrongValues: {
        readonly title: string;
        readonly steps: {
          readonly '1': string;
          readonly '2': string;
          readonly '3': string;
          readonly '4': string;
        };
      };
      readonly cutOff: {
        readonly title: string;
        readonly steps: {
          readonly '1': string;
          readonly '2': string;
        };
      };
      readonly noDt: {
        readonly title: string;
        readonly steps: {
          readonly '1': string;
          readonly '2': string;
          readonly '3': string;
          readonly '4': string;
          readonly '5': string;
        };
      };
      readonly noMove: {
        readonly title: string;
        readonly steps: {
          readonly '1': string;
          readonly '2': string;
          readonly '3': string;
        };
      };
      readonly noMotor: {
        readonly title: string;
        readonly steps: {
          readonly '1': string;
          readonly '2': string;
          readonly '3': string;
        };
      };
      readonly noLibrary: {
        readonly title: string;
        readonly steps: {
          readonly '1': string;
          readonly '2': string;
          readonly '3': string;
        };
      };
    };
  };
  readonly erase: {
    readonly open: string;
    readonly lead: string;
    readonly uncertain: string;
    readonly start: string;
    readonly running: string;
    readonly failed: string;
  };
  readonly obstacles: {
    readonly busy: string;
    readonly following: string;
    readonly 'not-fitting': string;
  };
  readonly library: {
    readonly unread: string;
    readonly empty: {
      readonly title: string;
      readonly lead: string;
      readonly hint: string;
    };
    readonly search: {
      readonly label: string;
      readonly nothing: string;
    };
    readonly models: {
      readonly title: string;
      readonly all: string;
      readonly make: string;
      readonly settings: (params: { readonly count: number }) => string;
      readonly archive: (params: { readonly count: Text }) => string;
      readonly archived: string;
      readonly latest: string;
    };
    readonly list: {
      readonly open: string;
    };
    readonly model: {
      readonly timerClass: string;
      readonly noClass: string;
      readonly facts: string;
      readonly noSettings: string;
      readonly servos: string;
      readonly servosUnknown: string;
      readonly servoWay: (params: { readonly low: Text; readonly high: Text }) => string;
      readonly archive: string;
      readonly unarchive: string;
      readonly remove: string;
      readonly withSettings: (params: { readonly count: number }) => string;
    };
    readonly setting: {
      readonly isOpen: string;
      readonly loadAgain: (params: { readonly count: number }) => string;
      readonly tags: string;
      readonly from: {
        readonly typed: string;
        readonly timer: string;
        readonly simulated: string;
        readonly backup: string;
        readonly file: string;
        readonly link: string;
      };
      readonly origin: (params: { readonly source: Text; readonly time: Text }) => string;
      readonly notShown: string;
      readonly gone: string;
    };
    readonly save: {
      readonly open: string;
      readonly over: (params: { readonly program: Text }) => string;
      readonly undo: (params: { readonly name: Text }) => string;
      readonly crossing: (params: { readonly from: Text; readonly to: Text }) => string;
      readonly asNew: string;
      readonly taken: (params: { readonly program: Text }) => string;
      readonly replace: string;
      readonly name: (params: { readonly of: 'model' | 'program' }) => string;
      readonly namePlace: string;
      readonly notSavable: string;
      readonly state: (params: { readonly changes: number; readonly name: Text }) => string;
    };
    readonly nameNeeded: string;
  };
  readonly line: {
    readonly empty: string;
    readonly unused: string;
    readonly all: string;
    readonly out: string;
    readonly in: string;
    readonly damaged: string;
    readonly request: (params: { readonly name: Text; readonly letters: Text }) => string;
    readonly reply: (params: { readonly name: Text; readonly letters: Text }) => string;
    readonly echo: (params: { readonly name: Text; readonly letters: Text }) => string;
    readonly unknown: (params: { readonly letter: Text }) => string;
    readonly names: {
      readonly GETTIMERS: string;
      readonly SETTIMERS: string;
      readonly GETSERVOPOS: string;
      readonly SETSERVO: string;
      readonly MOVETOFUNC: string;
      readonly GETSWVER: string;
      readonly UNLOCK: string;
      readonly JUMP2: string;
      readonly GETMEMORY: string;
      readonly SETMEMORY: string;
      readonly GETLOWRPM: string;
      readonly SETLOWRPM: string;
    };
    readonly rejected: {
      readonly noise: string;
      readonly length: string;
      readonly terminator: string;
      readonly checksum: string;
      readonly silence: string;
    };
    readonly error: {
      readonly framing: string;
      readonly parity: string;
      readonly break: string;
      readonly overrun: string;
      readonly other: string;
    };
    readonly position: (params: { readonly slot: Text; readonly servo: Text; readonly steps: Text }) => string;
    readonly motorStop: (params: { readonly time: Text }) => string;
    readonly reserved: (params: { readonly time: Text }) => string;
    readonly functions: (params: { readonly times: Text }) => string;
    readonly identity: (params: { readonly name: Text; readonly firmware: Text; readonly functions: Text; readonly memories: Text; readonly servos: Text }) => string;
    readonly memories: (params: { readonly count: number }) => string;
    readonly memoryUnsaid: string;
    readonly idleThrottle: (params: { readonly value: Text }) => string;
    readonly idleThrottleUnsaid: string;
    readonly acknowledged: string;
    readonly unreadable: {
      readonly 'wrong-length': string;
      readonly 'unknown-command': string;
      readonly 'unexpected-reply': string;
      readonly 'bad-identity': string;
      readonly 'identity-needed': string;
      readonly 'out-of-range': string;
      readonly 'not-an-integer': string;
      readonly 'wrong-count': string;
      readonly 'wrong-type': string;
      readonly 'unknown-word': string;
      readonly 'bad-capture': string;
      readonly 'bad-file': string;
      readonly 'bad-link': string;
      readonly 'newer-version': string;
      readonly 'too-large': string;
      readonly duplicate: string;
    };
    readonly goOn: string;
    readonly came: (params: { readonly number: number }) => string;
    readonly clear: string;
    readonly unidentified: string;
    readonly load: string;
    readonly filter: string;
    readonly searchHint: string;
    readonly counts: {
      readonly out: (params: { readonly count: number }) => string;
      readonly in: (params: { readonly count: number }) => string;
      readonly damaged: (params: { readonly count: number }) => string;
      readonly errors: (params: { readonly count: number }) => string;
    };
    readonly recording: (params: { readonly entries: number; readonly name: Text }) => string;
    readonly replay: string;
    readonly cannotReplay: string;
    readonly back: string;
    readonly noRecordingAt: (params: { readonly line: Text }) => string;
    readonly noRecording: string;
    readonly send: {
      readonly title: string;
      readonly lead: string;
      readonly bytes: string;
      readonly faults: {
        readonly hex: string;
        readonly 'too-long': string;
      };
      readonly preview: string;
      readonly send: string;
      readonly confirmTitle: string;
      readonly danger: string;
      readonly confirm: string;
      readonly sending: string;
      readonly answered: string;
      readonly unanswered: string;
    };
    readonly copyReport: string;
  };
  readonly ports: {
    readonly title: string;
    readonly forget: string;
    readonly settings: string;
    readonly settingsHint: string;
    readonly rate: string;
    readonly findRate: string;
    readonly baud: (params: { readonly rate: Text }) => string;
    readonly parity: string;
    readonly parities: {
      readonly none: string;
      readonly even: string;
      readonly odd: string;
    };
    readonly stopBits: string;
    readonly dtr: string;
    readonly rts: string;
    readonly signals: {
      readonly leave: string;
      readonly on: string;
      readonly off: string;
    };
    readonly reset: string;
  };
  readonly aboutTimer: {
    readonly title: string;
    readonly damage: string;
    readonly crowd: string;
    readonly found: string;
    readonly nothingFound: string;
    readonly quirkNames: {
      readonly 'timers-reply-66': string;
      readonly 'unlock-reply-6a': string;
      readonly 'memory-unknown': string;
      readonly 'memory-impossible': string;
      readonly 'bare-checksum': string;
      readonly 'times-big-endian': string;
      readonly 'servo-first': string;
      readonly 'servo-unanswered': string;
      readonly 'times-rounded': string;
      readonly 'memories-from-one': string;
      readonly 'positions-unchanged': string;
      readonly echo: string;
      readonly 'idle-throttle-unanswered': string;
      readonly 'identity-unusual': string;
      readonly 'idle-throttle-malformed': string;
      readonly 'replies-alike': string;
    };
    readonly assumed: string;
    readonly assumedHint: string;
    readonly forget: string;
    readonly assumptions: {
      readonly bigEndianTimes: string;
      readonly servoFirst: string;
      readonly memoriesFromOne: string;
      readonly bareChecksumRequests: string;
      readonly positionsNeedMove: string;
    };
  };
  readonly overview: {
    readonly readAll: string;
    readonly copyTo: string;
    readonly compareWith: (params: { readonly memory: Text }) => string;
    readonly readAt: (params: { readonly time: Text }) => string;
    readonly notCertain: string;
    readonly edited: string;
    readonly same: string;
    readonly differs: (params: { readonly count: number }) => string;
  };
  readonly preview: {
    readonly title: string;
    readonly guessed: string;
    readonly nameServos: string;
    readonly play: string;
    readonly speed: string;
    readonly time: string;
    readonly launch: string;
    readonly at: (params: { readonly what: Text; readonly time: Text }) => string;
    readonly sketch: string;
    readonly motor: {
      readonly true: string;
      readonly false: string;
    };
    readonly flies: string;
    readonly comesDown: string;
    readonly duties: {
      readonly rudder: string;
      readonly tailplane: string;
      readonly wing: string;
      readonly release: string;
      readonly other: string;
      readonly none: string;
    };
    readonly naming: {
      readonly lead: string;
      readonly duty: (params: { readonly servo: Text }) => string;
      readonly name: (params: { readonly servo: Text }) => string;
      readonly low: (params: { readonly servo: Text }) => string;
      readonly high: (params: { readonly servo: Text }) => string;
      readonly from: string;
      readonly to: string;
      readonly sense: (params: { readonly servo: Text }) => string;
      readonly otherSense: {
        readonly false: string;
        readonly true: string;
      };
      readonly rudderSense: {
        readonly false: string;
        readonly true: string;
      };
    };
  };
  readonly print: {
    readonly paper: string;
    readonly what: string;
    readonly parts: {
      readonly lines: string;
      readonly code: string;
    };
    readonly nothing: string;
    readonly choose: (params: { readonly chosen: Text }) => string;
    readonly clear: string;
    readonly simulated: string;
    readonly warnings: string;
    readonly notes: string;
    readonly codeHint: string;
    readonly unfinished: (params: { readonly count: number }) => string;
    readonly printed: (params: { readonly date: Text }) => string;
  };
  readonly theme: {
    readonly title: string;
    readonly names: {
      readonly system: string;
      readonly light: string;
      readonly dark: string;
      readonly sun: string;
    };
  };
  readonly settings: {
    readonly look: string;
    readonly expert: string;
    readonly expertHint: string;
    readonly kept: string;
  };
  readonly share: {
    readonly offer: {
      readonly lead: string;
      readonly link: string;
      readonly copy: string;
      readonly scan: string;
      readonly qr: (params: { readonly name: Text }) => string;
      readonly cut: string;
      readonly tooLong: string;
    };
    readonly received: {
      readonly title: string;
      readonly lead: string;
      readonly known: (params: { readonly name: Text }) => string;
      readonly modelChoice: string;
      readonly newModel: (params: { readonly name: Text }) => string;
      readonly keep: string;
      readonly discard: string;
      readonly unwritten: string;
    };
    readonly damaged: {
      readonly title: string;
      readonly bad: string;
    };
    readonly paste: {
      readonly title: string;
      readonly lead: string;
      readonly show: string;
      readonly notLink: string;
    };
  };
  readonly aboutPage: {
    readonly title: string;
    readonly version: (params: { readonly version: Text }) => string;
    readonly offline: string;
    readonly notOffline: string;
    readonly licences: string;
  };
  readonly whichModel: {
    readonly recognition: {
      readonly same: (params: { readonly model: Text; readonly when: Text }) => string;
      readonly like: (params: { readonly count: number; readonly model: Text }) => string;
      readonly several: (params: { readonly models: Text }) => string;
      readonly unknown: string;
      readonly yes: (params: { readonly model: Text }) => string;
      readonly choose: string;
      readonly ok: string;
      readonly dialog: {
        readonly title: string;
        readonly lead: string;
        readonly said: (params: { readonly model: Text }) => string;
        readonly moreMemories: string;
        readonly none: string;
        readonly newModel: string;
        readonly keep: string;
      };
    };
    readonly or: (params: { readonly names: Text; readonly last: Text }) => string;
    readonly others: (params: { readonly count: number }) => string;
    readonly memoryNames: {
      readonly label: (params: { readonly memory: Text }) => string;
      readonly give: string;
    };
    readonly crossing: {
      readonly title: (params: { readonly from: Text; readonly to: Text }) => string;
      readonly advice: string;
      readonly confirm: (params: { readonly from: Text; readonly to: Text }) => string;
      readonly memoryOf: (params: { readonly memory: Text; readonly model: Text }) => string;
    };
  };
  readonly settle: {
    readonly title: string;
    readonly lead: string;
    readonly safe: string;
    readonly danger: string;
    readonly blocked: string;
    readonly readIt: string;
    readonly which: string;
    readonly tryHint: string;
    readonly tryIt: string;
    readonly moved: string;
    readonly ask: string;
    readonly unknown: string;
    readonly send: string;
    readonly names: {
      readonly order: string;
      readonly unit: string;
      readonly count: string;
      readonly memories: string;
      readonly zeros: string;
      readonly layout: string;
      readonly stores: string;
      readonly moves: string;
      readonly unlock: string;
      readonly delay: string;
      readonly reserved: string;
    };
    readonly yes: string;
    readonly no: string;
    readonly unnumbered: string;
    readonly there: string;
    readonly delay: (params: { readonly ms: Text }) => string;
    readonly open: string;
  };
}
