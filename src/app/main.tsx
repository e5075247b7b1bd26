import '@fontsource-variable/inter/wght.css';
import './ui/fonts.css';
import './ui/tokens.css';
import './ui/base.css';
import './ui/shared.css';
import { openPage } from './open-page.js';

openPage(document.getElementById('app') as HTMLElement);
