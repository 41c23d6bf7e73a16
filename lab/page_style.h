#pragma once

/// What pages of tables and figures have beside golden/page/base.css: their style and the script that sorts tables.

namespace proofreel {

inline constexpr const char* page_style = R"css(
@media print { .scroll { overflow: visible; max-height: none; }
  thead { position: static; } th button { padding: 0; } }
body { margin: 0 auto; padding: 1.5rem clamp(1rem, 3vw, 3rem) 4rem; }
h1 { font-size: 1.8rem; margin: 0 0 .3rem; } h2 { font-size: 1.2rem; margin: 2.2rem 0 .6rem; }
p { max-width: 75ch; margin: .4rem 0; }
pre { padding: .6rem .8rem; background: var(--head); border: 1px solid var(--line); border-radius: 6px;
  overflow-x: auto; font: 14px/1.4 ui-monospace, "DejaVu Sans Mono", monospace;
  white-space: pre-wrap; overflow-wrap: anywhere; }
.scroll { overflow: auto; max-height: 94vh; padding: 0 8px 8px 0; }
.scroll:focus-visible { outline: 2px solid var(--link); }
thead { position: sticky; top: 0; z-index: 3; background: var(--paper); }
table { border-collapse: separate; border-spacing: 3px; }
th { font-weight: 600; text-align: center; background: var(--head); border-radius: 4px; padding: .25rem .4rem; }
th[scope=row] { text-align: left; white-space: nowrap; position: sticky; left: 0; z-index: 2; }
th small { color: var(--quiet); display: block; font-weight: 400; }
th[scope=row] small { max-width: 17rem; overflow: hidden; text-overflow: ellipsis; }
th button { font: inherit; color: inherit; background: none; border: 0; width: 100%; padding: .15rem; cursor: pointer; }
th[aria-sort=ascending] button::after { content: " \2191"; }
th[aria-sort=descending] button::after { content: " \2193"; }
a:focus-visible, button:focus-visible, summary:focus-visible, span:focus-visible { position: relative; z-index: 1; }
td { text-align: right; white-space: nowrap; padding: .25rem .5rem; border-radius: 4px; }
td.words { text-align: left; white-space: normal; max-width: 60ch; }
td.words, .plain td { border-bottom: 1px solid var(--line); border-radius: 0; }
.runs td, .key { min-width: 3.7rem; padding: 0; text-align: center; }
.runs td > *, .key { display: block; padding: .3rem .3rem .35rem; line-height: 1.2; }
.runs td > * { color: inherit; text-decoration: none; }
.runs a:hover b { text-decoration: underline; } .runs b { font-weight: 500; display: block; min-height: 1.2em; }
.sign { font-size: 1.15em; }
.stands { background: var(--stands); color: var(--stands-ink); }
.degrades { background: var(--degrades); color: var(--degrades-ink); }
.fails { background: var(--fails); color: var(--fails-ink); }
.too-slow { background: var(--slow); color: var(--slow-ink); }
.not-offered { background: var(--none); color: var(--none-ink); box-shadow: inset 0 0 0 1px var(--line); }
.best { box-shadow: inset 0 0 0 3px var(--frame); }
.legend { display: flex; flex-wrap: wrap; gap: .4rem 1.4rem; list-style: none; padding: .6rem 0; margin: 0; }
.legend li { display: flex; align-items: center; gap: .5rem; } .legend .key { min-width: 2.4rem; border-radius: 4px;
  text-align: center; }
figure { margin: 1rem 0; } figure svg { width: 100%; height: auto; max-width: 75rem; display: block; border-radius: 6px; }
figcaption { color: var(--quiet); } .verdict { font-size: 1.15rem; max-width: 80ch; border-left: 4px solid var(--link);
  padding: .2rem 0 .2rem .9rem; }
.point { cursor: help; } .point:focus-visible { outline: 4px solid var(--link); }
#tip { position: fixed; z-index: 9; max-width: 26rem; padding: .4rem .6rem; border-radius: 6px; pointer-events: none;
  background: var(--ink); color: var(--paper); font-size: .9rem; }
#tip[hidden] { display: none; }
details { margin: .5rem 0; } summary { cursor: pointer; font-weight: 600; }
)css";

/// Every button in a heading sorts its table's rows by its column: first upwards, then downwards. What has no number
/// comes last. Points of a figure tell their words to whom points at them or comes by with the keyboard.
inline constexpr const char* page_script = R"js(
for (const button of document.querySelectorAll('th button')) {
  button.addEventListener('click', () => {
    const th = button.closest('th'), table = th.closest('table'), column = Number(button.dataset.column);
    const down = th.getAttribute('aria-sort') === 'ascending';
    for (const other of table.querySelectorAll('th[aria-sort]')) other.removeAttribute('aria-sort');
    th.setAttribute('aria-sort', down ? 'descending' : 'ascending');
    const value = row => row.cells[column].dataset.sort ?? row.cells[column].textContent;
    const compare = (a, b) => {
      const x = value(a), y = value(b);
      if (x === '' || y === '') return (x === '') - (y === '');
      const order = isNaN(x) || isNaN(y) ? x.localeCompare(y) : x - y;
      return down ? -order : order;
    };
    const body = table.tBodies[0];
    body.append(...[...body.rows].sort(compare));
  });
}
const points = document.querySelectorAll('.point');
if (points.length) {
  const tip = document.createElement('div');
  tip.id = 'tip';
  tip.hidden = true;
  document.body.append(tip);
  const show = point => {
    tip.textContent = point.dataset.words;
    tip.hidden = false;
    const box = point.getBoundingClientRect();
    const left = Math.min(box.right + 10, innerWidth - tip.offsetWidth - 10);
    tip.style.left = Math.max(10, left) + 'px';
    tip.style.top = Math.max(10, box.top - tip.offsetHeight - 8) + 'px';
  };
  for (const point of points) {
    point.addEventListener('mouseenter', () => show(point));
    point.addEventListener('focus', () => show(point));
    for (const end of ['mouseleave', 'blur']) point.addEventListener(end, () => { tip.hidden = true; });
  }
}
)js";

}  // namespace proofreel
