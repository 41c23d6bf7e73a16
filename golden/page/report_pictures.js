// Part of the report's page: the pictures of the failure that is looked at, and the ways of comparing them.

function picturesOf() {
  const all = frames();
  page = {
    strip: make('div', {class: 'strip', role: 'group', 'aria-label': 'Golden frames'}, ...all.map(thumbnail)),
    scrub: make('input', {type: 'range', min: 0, max: all.length - 1, step: 1, id: 'scrub',
      'aria-label': 'Golden frame', oninput: event => go(Number(event.target.value))}),
    place: make('span', {class: 'quiet'}),
    message: make('p', {class: 'message', id: 'message'}),
    modes: make('div', {class: 'modes', role: 'group', 'aria-label': 'How the pictures are compared'},
      ...Object.entries(modes).map(([mode, words]) => make('button', {type: 'button', 'data-mode': mode,
        onclick: () => setMode(mode)}, words))),
    share: make('input', {type: 'range', min: 0, max: 100, id: 'share', 'aria-label': 'From expected to actual',
      oninput: event => setShare(Number(event.target.value))}),
    hint: make('span', {class: 'quiet'}),
    stage: make('div', {class: 'stage', id: 'stage'}),
    scale: make('span', {}),
    detail: make('div', {class: 'detail', id: 'detail'}),
  };
  const scrubber = all.length > 1 ? [page.strip, make('div', {class: 'scrub'}, page.scrub, page.place)] : [];
  const step = (by, words) => make('button', {type: 'button', class: 'plain', 'aria-label': words,
    onclick: () => magnify(by)}, by > 0 ? '+' : '−');
  page.head = make('div', {class: 'detail-head'}, make('h3', {}, 'Where most differs'), step(-1, 'Magnify less'),
    page.scale, step(1, 'Magnify more'));
  const tools = make('div', {class: 'tools'}, page.modes, page.hint, page.share);
  return [...scrubber, page.message, tools, page.stage, page.head, page.detail];
}

function thumbnail(each, index) {
  const sign = make('b', {class: 'sign' + (each.passed ? ' passed' : '')}, each.passed ? '✓' : '✗');
  return make('button', {type: 'button', title: each.verdict, onclick: () => go(index)},
    make('img', {src: each.actual || each.expected, alt: ''}), make('span', {}, each.label, sign));
}

function showFrame() {
  const now = item();
  state.at = now.place ? {x: now.place.x + now.place.width / 2, y: now.place.y + now.place.height / 2} : null;
  [...page.strip.children].forEach((button, index) =>
    button.setAttribute('aria-current', String(index === state.frame)));
  page.strip.children[state.frame].scrollIntoView({block: 'nearest', inline: 'nearest'});
  page.scrub.value = state.frame;
  page.scrub.setAttribute('aria-valuetext', `${now.label}: ${now.verdict}`);
  page.place.textContent = `${now.label}, ${state.frame + 1} of ${frames().length}`;
  page.message.replaceChildren(make('b', {}, `${now.label}: `), now.message || 'as blessed, to the last pixel.');
  page.message.classList.toggle('passed', now.passed);
  page.stage.replaceChildren(paneOf(now, 'expected', 'Expected: the picture that was blessed'),
    paneOf(now, 'actual', 'Actual: the picture of this run'), paneOf(now, 'heat', 'Heat: what differs, and how much'));
  const kinds = ['expected', 'actual', 'heat'].filter(kind => now[kind]);
  page.detail.replaceChildren(...kinds.map(kind => cropOf(now, kind)));
  showMode();
}

// Of what is equal only the expected picture is kept.
const absence = (now, kind) => kind === 'expected' ? 'There is no reference.' :
    now.verdict === 'orphan' ? 'Nothing asks for this picture.' : 'The same picture as expected.';

function paneOf(now, kind, caption) {
  const scale = () => make('span', {class: 'scale', title: 'from hardly visible to opposite'});
  const words = kind === 'heat' ? [caption + ' ', scale()] : [caption];
  const picture = now[kind] ? make('div', {class: 'picture', onpointerdown: grab, onpointermove: drag},
    make('img', {src: now[kind], alt: `${kind}, ${now.label}`, draggable: 'false', onload: layOut}),
    make('div', {class: 'marker'})) : make('div', {class: 'no-picture'}, absence(now, kind));
  return make('figure', {class: kind}, make('figcaption', {}, ...words), picture);
}

function cropOf(now, kind) {
  return make('figure', {}, make('figcaption', {}, kind), make('div', {class: 'crop'},
    make('img', {src: now[kind], alt: `${kind}, a detail magnified`, onload: layOut})));
}

// Which modes make sense for what there is.
const offers = mode => mode === 'side' ||
    Boolean(mode === 'heat' ? item().heat : item().expected && item().actual);
const modeNow = () => offers(state.mode) ? state.mode : 'side';

function showMode() {
  const mode = modeNow();
  page.stage.dataset.mode = mode;
  page.stage.dataset.shown = state.shown;
  for (const button of page.modes.children) {
    button.setAttribute('aria-pressed', String(button.dataset.mode === mode));
    button.disabled = !offers(button.dataset.mode);
  }
  page.share.hidden = mode !== 'swipe' && mode !== 'onion';
  const hints = {swipe: 'expected | actual', blink: 'showing ' + state.shown, onion: 'expected to actual'};
  page.hint.textContent = hints[mode] ?? '';
  showShare();
  layOut();
}

function showShare() {
  const unit = modeNow() === 'onion' ? state.share / 100 : state.share + '%';
  page.stage.style.setProperty('--share', unit);
  page.share.value = state.share;
}

// Pictures are shown in whole multiples of their size where there is room, so that their pixels stay what they are.
function scaleOf(widest, tallest) {
  const columns = modeNow() === 'side' && innerWidth > 832 ? 2 : 1;
  const padding = parseFloat(getComputedStyle($('main')).paddingLeft);
  const room = ($('main').clientWidth - 2 * padding - 16 * (columns - 1)) / columns;
  const fit = Math.min(room / widest, Math.max(1, 0.66 * innerHeight / tallest));
  return fit >= 1 ? Math.floor(fit) : fit;
}

function layOut() {
  const images = [...page.stage.querySelectorAll('img')].filter(image => image.naturalWidth);
  if (!images.length) return;
  const scale = scaleOf(Math.max(...images.map(i => i.naturalWidth)), Math.max(...images.map(i => i.naturalHeight)));
  for (const image of images) {
    image.style.width = image.naturalWidth * scale + 'px';
    image.style.imageRendering = scale >= 1 ? 'pixelated' : 'auto';
  }
  for (const none of page.stage.querySelectorAll('.no-picture')) none.style.width = images[0].style.width;
  layOutDetail(scale);
}

function layOutDetail(scale) {
  const crops = [...page.detail.querySelectorAll('.crop')], none = !state.at || crops.length < 2;
  page.detail.hidden = page.head.hidden = none;
  for (const marker of page.stage.querySelectorAll('.marker')) marker.hidden = none;
  if (none) return;
  page.scale.textContent = `${state.scale} ×`;
  let seen = null;
  for (const crop of crops) seen = placeCrop(crop) ?? seen;
  if (seen) for (const marker of page.stage.querySelectorAll('.marker')) {
    Object.assign(marker.style, {left: seen.x * scale + 'px', top: seen.y * scale + 'px',
      width: seen.width * scale + 'px', height: seen.height * scale + 'px'});
  }
}

// Centres the crop where the picture allows; returns what of the picture it shows.
function placeCrop(crop) {
  const image = crop.firstChild, k = state.scale;
  if (!image.naturalWidth) return null;
  const start = (at, room, size) => Math.max(0, Math.min(Math.floor(at - room / 2), size - room));
  const width = Math.min(crop.clientWidth / k, image.naturalWidth);
  const height = Math.min(crop.clientHeight / k, image.naturalHeight);
  const x = start(state.at.x, width, image.naturalWidth), y = start(state.at.y, height, image.naturalHeight);
  Object.assign(image.style, {width: image.naturalWidth * k + 'px', left: -x * k + 'px', top: -y * k + 'px'});
  return {x, y, width, height};
}

// ---- what can be done with them

function setMode(mode) {
  if (!offers(mode)) return;
  state.mode = mode;
  showMode();
  note();
}

function setShare(share) {
  state.share = Math.max(0, Math.min(100, share));
  showShare();
}

function magnify(by) {
  const steps = [2, 4, 8, 12, 16, 24];
  state.scale = steps[Math.max(0, Math.min(steps.length - 1, steps.indexOf(state.scale) + by))];
  layOut();
}

function lookAt(point) {
  state.at = point;
  layOut();
}

function backToWorst() {
  const place = item().place;
  if (place) lookAt({x: place.x + place.width / 2, y: place.y + place.height / 2});
}

function blink() {
  state.shown = state.shown === 'actual' ? 'expected' : 'actual';
  if (page && modeNow() === 'blink') showMode();
}
let byHand = matchMedia('(prefers-reduced-motion: reduce)').matches;
setInterval(() => { if (!byHand && state.mode === 'blink') blink(); }, 700);

// In swipe mode a picture is dragged over; else a click magnifies what is there.
function grab(event) {
  if (modeNow() === 'swipe') return swipeTo(event);
  const image = event.currentTarget.firstChild, box = image.getBoundingClientRect();
  const k = image.naturalWidth / box.width;
  lookAt({x: (event.clientX - box.left) * k, y: (event.clientY - box.top) * k});
}
function drag(event) {
  if (event.buttons & 1 && modeNow() === 'swipe') swipeTo(event);
}
function swipeTo(event) {
  const box = event.currentTarget.getBoundingClientRect();
  setShare(100 * (event.clientX - box.left) / box.width);
}
