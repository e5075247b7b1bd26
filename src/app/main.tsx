import { openPage } from './open-page.js';
import './ui/base.css';
import './bench/bench.css';
import './program/fields.css';
import './shell/frame.css';
import './connect/help.css';
import './shell/knowledge.css';
import './line/line.css';
import './connect/link.css';
import './memories/overview.css';
import './timeline/preview/preview.css';
import './program/program.css';
import './program/range.css';
import './program/table.css';
import './timeline/timeline.css';
import './write/write.css';

openPage(document.getElementById('app') as HTMLElement);
