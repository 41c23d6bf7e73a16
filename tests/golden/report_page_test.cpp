#include "golden/report_page.h"

#include <catch2/catch.hpp>

#include "tests/browser.h"
#include "tests/golden/report_examples.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;
using namespace test;

/// What the script notes in the example's page, once it and its pictures are there: `note` keeps a word, `press` a key,
/// `later` goes on after so many milliseconds.
std::string notes(const std::string& script, const std::string& hash = {}) {
  const ScratchFolder folder;
  write_example(folder / "report", folder / "references");
  const std::string driver =
      "{ const words = [], note = word => { words.push(word); document.title = words.join(', '); };"
      "const press = (key, target = document.body) =>"
      "  target.dispatchEvent(new KeyboardEvent('keydown', {key, bubbles: true, cancelable: true}));"
      "const stage = () => $('stage').dataset.mode;"
      "const style = (kind, what) => getComputedStyle(document.querySelector(`#stage .${kind} img`))[what];"
      "const heading = () => document.querySelector('#main h2').textContent;"
      "const later = (ms, act) => setTimeout(act, ms);"
      "addEventListener('load', () => {" +
      script + "}); }";
  const std::string page = folder_in_browser((folder / "report"), driver, hash);
  const std::size_t start = page.find("<title>") + 7;
  return page.substr(start, page.find("</title>") - start);
}

TEST_CASE("The page opens at the first failing frame of the first failure, all its pictures there", "[report]") {
  REQUIRE(
      notes("note(heading());"
            "note($('message').textContent);"
            "note([...document.querySelectorAll('#stage img, #detail img')].map(i => i.naturalWidth).join(' '));") ==
      "ball, frame 15: 128 of 2560 pixels differ., 64 64 64 64 64 64");
}

TEST_CASE("The keys 1 to 5 show the pictures side by side, by swipe, blinking, as onion skin and as heat", "[report]") {
  REQUIRE(notes("for (const key of '12345') { press(key); note(stage()); }") == "side, swipe, blink, onion, heat");
  REQUIRE(
      notes("for (const button of document.querySelectorAll('.modes button')) { button.click(); note(stage()); }") ==
      "side, swipe, blink, onion, heat");
}

TEST_CASE("The swipe's line follows slider, keys and pointer; the actual picture starts there", "[report]") {
  REQUIRE(
      notes("press('2'); note(style('actual', 'clipPath'));"
            "press('.'); press('.'); note(style('actual', 'clipPath'));"
            "press(','); note(style('actual', 'clipPath'));"
            "$('share').value = 20; $('share').dispatchEvent(new Event('input'));"
            "note(style('actual', 'clipPath'));"
            "const picture = document.querySelector('#stage .actual .picture'), box = picture.getBoundingClientRect();"
            "picture.dispatchEvent(new PointerEvent('pointerdown', {clientX: box.left + 0.75 * box.width}));"
            "note(style('actual', 'clipPath')); note(style('expected', 'clipPath'));") ==
      "inset(0px 0px 0px 50%), inset(0px 0px 0px 60%), inset(0px 0px 0px 55%), inset(0px 0px 0px 20%), "
      "inset(0px 0px 0px 75%), none");
}

TEST_CASE("Blinking takes turns by itself, and by hand once the space bar is pressed", "[report]") {
  REQUIRE(notes("const shown = () => style('actual', 'visibility') === 'visible' ? 'actual' : 'expected';"
                "const both = () => style('actual', 'visibility') !== style('expected', 'visibility');"
                "press('3');"
                "const first = shown();"
                "note(both());"
                "later(800, () => { note(shown() !== first); press(' '); const second = shown();"
                "  later(2000, () => { note(shown() === second); press(' '); note(shown() !== second); }); });") ==
          "true, true, true, true");
}

TEST_CASE("The onion skin lets the actual picture through by its share", "[report]") {
  REQUIRE(notes("press('4'); note(style('actual', 'opacity'));"
                "for (let i = 0; i < 30; ++i) press('.'); note(style('actual', 'opacity'));"
                "for (let i = 0; i < 30; ++i) press(','); note(style('actual', 'opacity'));") == "0.5, 1, 0");
}

TEST_CASE("Arrows, scrubber and thumbnails go through the golden frames and stop at the ends", "[report]") {
  REQUIRE(notes("const frame = () => note(document.querySelector('.strip [aria-current=true]').textContent);"
                "press('ArrowRight'); frame(); press('ArrowRight'); frame();"
                "press('ArrowLeft'); press('ArrowLeft'); frame(); press('ArrowLeft'); frame();"
                "$('scrub').value = 1; $('scrub').dispatchEvent(new Event('input')); frame();"
                "document.querySelectorAll('.strip button')[2].click(); frame();") ==
          "frame 29✗, frame 29✗, frame 0✓, frame 0✓, frame 15✗, frame 29✗");
}

TEST_CASE("A frame that passed shows its one picture and offers no comparison", "[report]") {
  REQUIRE(notes("press('5'); press('ArrowLeft'); note(stage());"
                "note(document.querySelectorAll('.modes button:disabled').length);"
                "note(document.querySelector('#stage .actual').textContent); note($('detail').hidden);"
                "press('ArrowRight'); note(stage());") ==
          "side, 4, Actual: the picture of this runThe same picture as expected., true, heat");
}

TEST_CASE("The detail shows where most differs, magnified, and looks where one clicks", "[report]") {
  REQUIRE(
      notes(
          "const at = () => document.querySelector('.crop img').style;"
          "const first = at().left + at().width; note(at().width);"
          "press('+'); press('+'); press('+'); note(at().width); const left = at().left;"
          "const picture = document.querySelector('#stage .expected .picture'), box = picture.getBoundingClientRect();"
          "picture.dispatchEvent(new PointerEvent('pointerdown', {clientX: box.right - 2, clientY: box.top + 2}));"
          "note(at().left !== left); press('z'); note(at().left === left);"
          "press('-'); press('-'); press('-'); note(at().left + at().width === first);") ==
      "512px, 1536px, true, true, true");
}

TEST_CASE("Down and up go from failure to failure; filter and verdicts narrow them down", "[report]") {
  REQUIRE(notes("press('ArrowDown'); note(heading()); press('k'); note(heading());"
                "press('/'); note(document.activeElement.id);"
                "$('filter').value = 'GONE'; $('filter').dispatchEvent(new Event('input'));"
                "note($('failed').children.length + ' ' + $('passed').children.length);"
                "$('filter').value = ''; $('filter').dispatchEvent(new Event('input'));"
                "const chip = word => [...$('chips').children].find(c => c.textContent.startsWith(word)).click();"
                "chip('physics'); note($('failed').children.length + ' ' + $('passed').children.length);"
                "chip('passed'); note($('failed').children.length + ' ' + $('passed').children.length);") ==
          "&lt;b&gt;gone&lt;/b&gt;, ball, filter, 1 0, 1 0, 0 2");
}

TEST_CASE("Keys typed into the filter, and letters with Ctrl, are not taken for commands", "[report]") {
  REQUIRE(notes("press('5', $('filter')); note(stage());"
                "document.body.dispatchEvent(new KeyboardEvent('keydown', {key: 'j', ctrlKey: true, bubbles: true}));"
                "note(heading());") == "side, ball");
}

TEST_CASE("A question mark opens the list of keys, and while it is open no other key acts", "[report]") {
  REQUIRE(notes("press('?'); note($('help').open); press('5'); note(stage());"
                "$('help').querySelector('button').click(); note($('help').open);") == "true, side, false");
}

TEST_CASE("The commands are there to be copied; what cannot be blessed has none to bless", "[report]") {
  REQUIRE(notes("note($('reproduce').textContent); note($('bless').textContent);"
                "press('c'); later(300, () => { note($('said').textContent);"
                "press('j'); note($('bless') === null); });") ==
          "proofreel check ball, proofreel bless ball, Copied: proofreel check ball, true");
}

TEST_CASE("The address leads to a failure, a frame and a way of comparing", "[report]") {
  REQUIRE(notes("note(heading()); note($('message').textContent.slice(0, 8)); note(stage());",
                "#ball/frame%2029/onion") == "ball, frame 29, onion");
  REQUIRE(notes("note(heading());", "#no/such/place") == "ball");
}

TEST_CASE("Whatever text comes into the report stays text", "[report]") {
  REQUIRE(notes("press('j'); note(heading()); note(document.querySelectorAll('#main i, #side b').length);") ==
          "&lt;b&gt;gone&lt;/b&gt;, 0");
}

TEST_CASE("The report asks for nothing from elsewhere", "[report]") {
  const std::string page = report_page(example_report());
  for (const char* word : {"http:", "https:", "//cdn", "<link", "@import", "url("}) {
    REQUIRE_THAT(page, !Contains(word));
  }
}

TEST_CASE("When all passed, the page says so, and lists each on a line", "[report]") {
  Report report = example_report();
  report.entries.erase(report.entries.begin(), report.entries.begin() + 2);
  const std::string page = in_browser(report_page(report), "");
  REQUIRE_THAT(page, Contains("<title>All passed - golden check</title>") && Contains("All 2 checks passed"));
  REQUIRE_THAT(page, Contains("<li>calm</li>") && Contains(">near (tolerated)</li>"));
}

}  // namespace
}  // namespace proofreel
