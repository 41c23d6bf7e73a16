// Part of the report's page: keys, the address, and the start of it all.

function go(index) {
  state.frame = Math.max(0, Math.min(frames().length - 1, index));
  showFrame();
  note();
}

function turn(by) {
  const shown = failed.filter(isShown);
  if (!shown.length) return;
  const here = shown.indexOf(state.entry);
  choose(shown[here < 0 ? 0 : Math.max(0, Math.min(shown.length - 1, here + by))]);
}

const keys = {
  j: () => turn(1), ArrowDown: () => turn(1), k: () => turn(-1), ArrowUp: () => turn(-1),
  c: () => copy(state.entry.reproduce), b: () => copy(state.entry.bless),
};
const pictureKeys = {
  ArrowRight: () => go(state.frame + 1), ArrowLeft: () => go(state.frame - 1),
  ',': () => setShare(state.share - 5), '.': () => setShare(state.share + 5),
  '+': () => magnify(1), '=': () => magnify(1), '-': () => magnify(-1), z: backToWorst,
  ' ': () => { byHand = true; state.mode === 'blink' ? blink() : setMode('blink'); },
};
Object.keys(modes).forEach((mode, index) => { pictureKeys[index + 1] = () => setMode(mode); });

// A control that has the focus keeps the keys it knows itself.
function keepsKey(target, key) {
  if (target.matches('input[type=search], textarea')) return true;
  if (target.matches('input[type=range]')) return key.startsWith('Arrow');
  return target.matches('button') && key === ' ';
}

function onKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || $('help').open) return;
  if (event.key === 'Escape' && event.target === $('filter')) return $('main').focus();
  if (keepsKey(event.target, event.key)) return;
  const act = event.key === '?' ? () => $('help').showModal() : event.key === '/' ? () => $('filter').focus() :
      state.entry && (keys[event.key] ?? (frames().length ? pictureKeys[event.key] : null));
  if (!act) return;
  event.preventDefault();
  act();
}

// ---- where one is, so that a place can be sent to somebody: #name/frame 120/swipe

let noted = null;
function note() {
  noted = '#' + [state.entry.name, frames().length ? item().label : '', state.mode].map(encodeURIComponent).join('/');
  if (location.hash !== noted) location.replace(noted);
}

function follow() {
  if (location.hash === noted) return;
  const [name, label, mode] = location.hash.slice(1).split('/').map(decodeURIComponent);
  const entry = failed.find(each => each.name === name) ?? failed[0];
  if (mode in modes) state.mode = mode;
  choose(entry, label);
}

function showAllPassed() {
  const check = '<svg viewBox="0 0 48 48" aria-hidden="true"><circle cx="24" cy="24" r="21"/>' +
      '<path d="M15 25l6 6 12-14"/></svg>';
  const box = make('div', {class: 'all-passed'});
  box.innerHTML = check;
  box.append(make('h2', {}, `All ${count(report.entries.length, 'check')} passed`),
    make('p', {class: 'quiet'}, 'Every state and every picture is the one that was blessed, within its tolerance.'));
  $('main').replaceChildren(box);
}

showSummary();
showChips();
showList();
if (failed.length) follow(); else showAllPassed();
addEventListener('hashchange', () => { if (failed.length) follow(); });
addEventListener('keydown', onKey);
addEventListener('resize', () => { if (page && state.entry && frames().length) layOut(); });
$('filter').addEventListener('input', showList);
$('help-open').addEventListener('click', () => $('help').showModal());
