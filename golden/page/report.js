'use strict';
// The report of a check as a page. All text comes in as text, never as HTML. `state` is all that can be changed;
// show*() bring the page in line with it.
const report = JSON.parse(document.getElementById('data').textContent);
const $ = id => document.getElementById(id);
const make = (tag, attributes = {}, ...children) => {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) node.addEventListener(name.slice(2), value);
    else if (value === true) node.setAttribute(name, '');
    else if (value !== false && value !== null) node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
};

const failed = report.entries.filter(entry => !entry.passed);
const modes = {side: 'Side by side', swipe: 'Swipe', blink: 'Blink', onion: 'Onion skin', heat: 'Heat'};
const meanings = {
  physics: 'The bodies moved differently: the state of the simulation is not the one that was blessed, and the ' +
      'picture follows from it.',
  drawing: 'The picture is drawn differently.',
  both: 'The bodies moved differently, and the drawing changed as well: frames whose state is equal differ, too.',
  missing: 'There is no usable reference to compare with. Nothing but bless writes one.',
  size: 'The picture has another size than its reference.',
  orphan: 'A reference is kept that nothing asks for any more.',
  nondeterministic: 'Two runs just now gave two results, so no reference can hold: the fault is in the program.',
  expectation: 'The scenario itself says what must hold, and it does not.',
  error: 'This could not be run, so nobody knows whether it is right.',
};
const motionIsSame = ' The motion is the same to the last bit.';
const state = {entry: null, frame: 0, mode: 'side', share: 50, shown: 'actual', scale: 8, at: null, verdict: null};
let page = null;  // the parts of the main area that change with the state

// ---- what was checked

const count = (number, word) => `${number.toLocaleString('en')} ${word}${number === 1 ? '' : 's'}`;
// The gravest first, which tells most.
const order = ['error', 'nondeterministic', 'both', 'physics', 'drawing', 'size', 'missing', 'expectation', 'orphan'];
const verdictsOf = entry => {
  const found = new Set(entry.items.filter(item => !item.passed).map(item => item.verdict));
  if (found.has('both')) ['physics', 'drawing'].forEach(part => found.delete(part));
  return order.filter(verdict => found.has(verdict));
};
const badge = verdict => make('span', {class: 'badge ' + verdict, title: meanings[verdict]}, verdict);
const isShown = entry => entry.name.toLowerCase().includes($('filter').value.trim().toLowerCase()) &&
    (state.verdict === null || (entry.passed ? 'passed' : verdictsOf(entry)).includes(state.verdict));

function showSummary() {
  const {number, count: shards} = report.shard;
  const shard = shards > 1 ? ` This is shard ${number} of ${shards}.` : '';
  const words = failed.length ? [make('b', {}, `${failed.length} of ${report.entries.length} failed.`)] :
                                [make('b', {}, `All ${report.entries.length} passed.`)];
  $('summary').append(...words, `${shard} Checked by ${report.program}.`);
  document.title = failed.length ? `${failed.length} failed - golden check` : 'All passed - golden check';
}

function showChips() {
  const counts = new Map();
  for (const verdict of failed.flatMap(verdictsOf)) counts.set(verdict, (counts.get(verdict) ?? 0) + 1);
  const passed = report.entries.length - failed.length;
  if (passed) counts.set('passed', passed);
  if (counts.size < 2) return;
  const chip = (verdict, words) => make('button', {type: 'button', 'aria-pressed': String(state.verdict === verdict),
    onclick: () => { state.verdict = state.verdict === verdict ? null : verdict; showChips(); showList(); }}, words);
  $('chips').replaceChildren(chip(null, 'all'), ...[...counts].map(([verdict, n]) => chip(verdict, `${verdict} ${n}`)));
}

function showList() {
  const entries = report.entries.filter(isShown);
  const row = entry => make('li', {}, make('button', {type: 'button', 'aria-current': entry === state.entry && 'true',
    onclick: () => choose(entry)}, entry.name, make('span', {}, ...verdictsOf(entry).slice(0, 1).map(badge))));
  const line = entry => {
    const tolerated = entry.items.find(item => item.verdict === 'tolerated');
    return make('li', tolerated ? {title: tolerated.message} : {}, entry.name + (tolerated ? ' (tolerated)' : ''));
  };
  const passed = entries.filter(entry => entry.passed);
  $('failed').replaceChildren(...entries.filter(entry => !entry.passed).map(row));
  $('passed').replaceChildren(...passed.map(line));
  $('passed-title').textContent = passed.length ? `${passed.length} passed` : '';
  $('nothing').hidden = entries.length > 0;
}

// ---- the failure that is looked at

const frames = () => state.entry.items.filter(item => item.expected || item.actual);
const item = () => frames()[state.frame];

function choose(entry, label = null) {
  state.entry = entry;
  const all = frames();
  const wanted = all.findIndex(each => each.label === label);
  state.frame = wanted >= 0 ? wanted : Math.max(0, all.findIndex(each => !each.passed));
  $('main').replaceChildren(...mainOf(entry));
  showList();
  document.querySelector('#failed [aria-current]')?.scrollIntoView({block: 'nearest'});
  if (all.length) showFrame();
  note();
}

function mainOf(entry) {
  const kinds = verdictsOf(entry);
  const sameMotion = kinds[0] === 'drawing' && entry.items.some(each => each.label.startsWith('frame'));
  const head = [make('div', {class: 'title'}, make('h2', {}, entry.name), ...kinds.map(badge)),
    make('p', {class: 'meaning'}, (meanings[kinds[0]] ?? '') + (sameMotion ? motionIsSame : ''))];
  const pictures = frames().length ? picturesOf() : [], others = othersOf(entry);
  const found = frames().every(each => each.passed) ? [...others, ...pictures] : [...pictures, ...others];
  return [...head, ...found, ...commandsOf(entry)];
}

// What failed without a picture to show for it.
function othersOf(entry) {
  const others = entry.items.filter(each => !each.passed && !each.expected && !each.actual);
  if (!others.length) return [];
  const list = others.map(each => make('li', {}, make('b', {}, each.label), make('span', {}, each.message)));
  return [make('ul', {class: 'others', 'aria-label': 'Also found'}, ...list)];
}

function commandsOf(entry) {
  const row = (label, command, id) => command ? [make('span', {}, label), make('code', {id}, command),
    make('button', {type: 'button', class: 'plain', onclick: () => copy(command)}, 'Copy')] : [];
  const rows = [...row('Reproduce', entry.reproduce, 'reproduce'), ...row('Accept as right', entry.bless, 'bless')];
  return rows.length ? [make('div', {class: 'commands'}, ...rows)] : [];
}

async function copy(text) {
  if (!text) return;
  try {
    await navigator.clipboard.writeText(text);
  } catch {  // the old way, where the new one is not allowed
    const area = make('textarea', {}, text);
    document.body.append(area);
    area.select();
    document.execCommand('copy');
    area.remove();
  }
  say('Copied: ' + text);
}

function say(words) {
  $('said').textContent = words;
  const toast = make('div', {class: 'toast'}, words);
  document.body.append(toast);
  setTimeout(() => toast.remove(), 1800);
}
