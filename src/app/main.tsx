import { openPage } from './open-page.js';
import './styles/base.css';
import './styles/bench.css';
import './styles/fields.css';
import './styles/frame.css';
import './styles/help.css';
import './styles/knowledge.css';
import './styles/line.css';
import './styles/link.css';
import './styles/overview.css';
import './styles/preview.css';
import './styles/program.css';
import './styles/range.css';
import './styles/table.css';
import './styles/timeline.css';
import './styles/write.css';

openPage(document.getElementById('app') as HTMLElement);
