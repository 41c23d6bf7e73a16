#pragma once

/// What the gallery's page has beside golden/page/base.css.

namespace proofreel {

inline constexpr const char* gallery_style = R"css(
:root { --comment: #6a6f76; --string: #2d6a4f; --number: #9a5b00; --keyword: #8a3f8a; --word: #0b5394; }
@media (prefers-color-scheme: dark) {
  :root { --comment: #93a1ad; --string: #8fd3b0; --number: #f0be72; --keyword: #d7a3e0; --word: #8cc4ff; }
}
html { scroll-padding-top: 3.6rem; }
body { margin: 0; }
header, main > section { max-width: 92rem; margin: 0 auto; padding: 0 clamp(1rem, 3vw, 3rem); }
header { padding-top: 2rem; }
h1 { font-size: 2rem; margin: 0; letter-spacing: -.01em; }
h2 { font-size: 1.35rem; margin: 2.4rem 0 .2rem; } h3 { font-size: 1.1rem; margin: 0; }
p { max-width: 75ch; margin: .3rem 0; }
nav { position: sticky; top: 0; z-index: 4; background: var(--paper); border-bottom: 1px solid var(--line); margin-top: 1rem; }
nav ol { max-width: 92rem; margin: 0 auto; padding: .6rem clamp(1rem, 3vw, 3rem); list-style: none; display: flex; gap: .3rem 1.4rem;
  flex-wrap: wrap; font-size: .95rem; }
nav a { text-decoration: none; white-space: nowrap; } nav a:hover { text-decoration: underline; }
.sheet { display: grid; grid-template-columns: repeat(auto-fill, minmax(14rem, 1fr)); gap: 1.1rem; padding: .7rem 0 0; margin: 0;
  list-style: none; }
.sheet a { display: block; color: inherit; text-decoration: none; }
.sheet img, .sheet video { width: 100%; height: auto; aspect-ratio: 16 / 9; object-fit: contain; display: block; border-radius: 6px;
  background: var(--head); box-shadow: inset 0 0 0 1px var(--line), 0 0 0 1px var(--line); }
.sheet a:hover img, .sheet a:hover video { box-shadow: 0 0 0 3px var(--link); }
.sheet span { display: block; padding: .35rem .1rem 0; line-height: 1.3; font-size: .95rem; }
article { padding: 1.6rem 0; border-top: 1px solid var(--line); }
article .pair { display: grid; grid-template-columns: minmax(0, 1.15fr) minmax(0, 1fr); gap: 1.2rem; margin: .8rem 0 .5rem; align-items: start; }
article video { width: 100%; display: block; border-radius: 6px; box-shadow: 0 0 0 1px var(--line); background: var(--head); }
article pre { margin: 0; padding: .8rem 1rem; overflow: auto; height: 0; min-height: 100%; border: 1px solid var(--line); border-radius: 6px;
  background: var(--head); font: 13px/1.5 ui-monospace, "DejaVu Sans Mono", monospace; tab-size: 2;
  white-space: pre-wrap; overflow-wrap: anywhere; }
.links { font-size: .92rem; color: var(--quiet); max-width: none; } .links a { white-space: nowrap; }
code { font: .92em ui-monospace, "DejaVu Sans Mono", monospace; }
.c { color: var(--comment); font-style: italic; } .s { color: var(--string); } .n { color: var(--number); }
.k { color: var(--keyword); } .w { color: var(--word); }
footer { max-width: 92rem; margin: 2rem auto; padding: 0 clamp(1rem, 3vw, 3rem); color: var(--quiet); }
@media (max-width: 62rem) { article .pair { grid-template-columns: 1fr; } article pre { height: auto; min-height: 0; max-height: 28rem; } }
)css";

/// Whoever points at a thumbnail sees it move, unless they have asked for less motion. Of all films one plays.
inline constexpr const char* gallery_script = R"js(
const calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
for (const link of document.querySelectorAll('.sheet a')) {
  const still = link.querySelector('img');
  link.addEventListener('mouseenter', () => {
    if (calm) return;
    const film = document.createElement('video');
    Object.assign(film, { src: link.dataset.film, muted: true, loop: true, autoplay: true, poster: still.src });
    still.replaceWith(film);
    link.addEventListener('mouseleave', () => film.replaceWith(still), { once: true });
  });
}
const films = document.querySelectorAll('article video');
for (const film of films) film.addEventListener('play', () => films.forEach(other => other !== film && other.pause()));
)js";

}  // namespace proofreel
