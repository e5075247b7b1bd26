import type { Bench } from '../bench/bench.js';
import { AboutTimer, SETTLE } from '../connect/about-timer.js';
import { ConnectButtons } from '../connect/connect-buttons.js';
import type { Installation } from '../connect/installation.js';
import { PortList, SerialSettingsForm } from '../connect/port-list.js';
import { captureText } from '../line/recording.js';
import { captureNotes } from '../line/report.js';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { DtTimes } from '../program/dt-times.js';
import type { Preferences } from '../records/preferences.js';
import type { Erase } from '../settings/erase.js';
import { THEMES, type Theme } from '../settings/theme.js';
import { settleOf } from '../settle/settle.js';
import { SettleView } from '../settle/settle-view.js';
import { Check } from '../ui/check.js';
import { LanguageChoice } from '../ui/language-choice.js';
import { SegmentChoice } from '../ui/segment-choice.js';
import { SHAPES } from '../ui/shapes.js';
import { useQuery } from '../ui/use-query.js';
import type { Session } from '../work/session.js';
import { AboutPage } from './about-page.js';
import type { UpdateOffer } from './update-offer.js';
import type { Views } from './views.js';
import './settings-view.css';

export interface SettingsViewProps {
  readonly session: Session;
  readonly bench: Bench;
  readonly preferences: Preferences;
  readonly theme: Theme;
  readonly erase: Erase;
  readonly views: Views;
  readonly installation: Installation;
  readonly update: UpdateOffer;
}

/** What is set once, and the walk that settles with a timer what is open. */
export function SettingsView(props: SettingsViewProps) {
  const { session, bench, views } = props;
  if (views.path.value !== SETTLE) return <Settings {...props} />;
  const recording = (notes: readonly string[]): string => {
    const records = session.log.introduced(session.log.entries.value);
    return captureText(records, [...captureNotes(records), ...notes]);
  };
  const connect = <ConnectButtons session={session} part="first" />;
  return <SettleView {...{ session, recording, connect }} settle={settleOf(session, bench)} />;
}

/** The look of the page, the adapters, what this device keeps. */
function Settings(props: SettingsViewProps) {
  const { session, preferences, theme, erase, views, installation, update } = props;
  const { label, program, views: viewWords } = messages.value;
  const { settings: words, erase: eraseWords, theme: themeWords } = moreMessages.value;
  // A rail leads to the help, too.
  const areLinksBelow = useQuery(SHAPES.phone).value;
  return (
    <>
      <h1>{viewWords.names.settings}</h1>
      {areLinksBelow && (
        <p>
          <a class="alone" href="#help">
            {viewWords.names.help}
          </a>
        </p>
      )}
      <section class="stack setting">
        <h2>{label.language}</h2>
        <LanguageChoice />
      </section>
      <section class="stack setting">
        <h2>{words.look}</h2>
        <SegmentChoice
          name="theme"
          title={themeWords.title}
          choices={THEMES}
          names={themeWords.names}
          chosen={theme.chosen.value}
          onChoose={(name) => theme.choose(name)}
        />
      </section>
      <section class="stack setting">
        <h2>{program.dt}</h2>
        <DtTimes preferences={preferences} />
      </section>
      {!session.link.unavailable && (
        <section class="stack setting">
          <PortList session={session} onConnect={() => views.show('program')} />
          <SerialSettingsForm link={session.link} expert={views.expert.value} />
        </section>
      )}
      <div class="stack setting">
        <AboutTimer session={session} />
      </div>
      <section class="stack setting">
        <Check checked={views.expert.value} onChange={(checked) => views.setExpert(checked)}>
          {words.expert}
        </Check>
        <p class="hint">{words.expertHint}</p>
      </section>
      <section class="stack setting">
        <h2>{words.kept}</h2>
        <div class="buttons">
          <button type="button" onClick={() => erase.open()}>
            {eraseWords.open}
          </button>
        </div>
      </section>
      <AboutPage installation={installation} update={update} />
    </>
  );
}
