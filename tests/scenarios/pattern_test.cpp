#include <catch2/catch.hpp>

#include "scenarios/pattern.h"
#include "scene_text.h"

using namespace proofreel;

TEST_CASE("Finding gives the place and the captures") {
  CHECK(is_true("table.concat({('hello world'):find('o w')}, ' ') == '5 7'"));
  CHECK(is_true("table.concat({('key = value'):find('(%w+)%s*=%s*(%w+)')}, ' ') == '1 11 key value'"));
  CHECK(is_true("('abc'):find('b', 3) == nil and ('abc'):find('b', -2) == 2 and ('abc'):find('', 10) == nil"));
  CHECK(is_true("('a.b'):find('.', 1, true) == 2 and ('a+b'):find('+', 1, true) == 2 and ('abc'):find('') == 1"));
}

TEST_CASE("Ordinary patterns work on long texts") {
  CHECK(is_true("('  trimmed \\t'):match('^%s*(.-)%s*$') == 'trimmed'"));
  CHECK(is_true("#line:match('^%s*(.-)%s*$') == 20000", "line = '   ' .. ('x y z'):rep(4000) .. '   '"));
  CHECK(is_true("select(2, text:gsub('(%w+), (%w+)', '%2 %1')) == 2000", "text = ('left, right; '):rep(2000)"));
}

TEST_CASE("Classes, sets, anchors and frontiers match as Lua has it") {
  CHECK(is_true("('x1 Y2'):gsub('%a%d', '<%0>') == '<x1> <Y2>'"));
  CHECK(is_true("('a]b-c^d'):gsub('[]%-^]', '.') == 'a.b.c.d'"));
  CHECK(is_true("('0aF.g'):match('^[%x.]+') == '0aF.'"));
  CHECK(is_true("('THE (quick) fox'):find('%((%a+)%)') == 5 and ('THE (quick) fox'):match('%b()') == '(quick)'"));
  CHECK(is_true("('THE quick'):gsub('%f[%a]%a+', 'w') == 'w w'"));
  CHECK(is_true("('abab'):match('^(ab)%1$') == 'ab' and ('a$b'):match('$b') == '$b' and ('ab'):match('^^a') == nil"));
  CHECK(is_true("('hello'):match('()ll()') == 3 and select(2, ('hello'):match('()ll()')) == 5"));
  CHECK(is_true("('aa'):match('()%1') == nil"));
  CHECK(is_true("('aaa'):match('a-b') == nil and ('aaab'):match('a-b') == 'aaab' and ('b'):match('a?b') == 'b'"));
  CHECK(is_true("('\\0x'):match('%z?x') == 'x' and ('a\\0b'):match('%c') == '\\0'"));
}

TEST_CASE("gmatch walks on past empty matches") {
  CHECK(is_true("all == 'one|two||'",
                "all = ''\nfor w in ('one two'):gmatch('%a*') do all = all .. w .. '|' end\nall = all .. '|'"));
  CHECK(is_true("all == 'a=1;b=2;'",
                "all = ''\nfor k, v in ('a=1, b=2'):gmatch('(%w)=(%w)') do all = all..k..'='..v..';' end"));
  CHECK(is_true("all == '2'", "all = ''\nfor w in ('1 2'):gmatch('%d', 2) do all = all .. w end"));
  CHECK(is_true("all == '^a'", "all = ''\nfor w in ('b^a'):gmatch('^a') do all = all .. w end"));
}

TEST_CASE("gsub replaces by text, table and function") {
  CHECK(is_true("('abc'):gsub('', '-') == '-a-b-c-' and ('abc'):gsub('b*', 'x') == 'xaxcx'"));
  CHECK(is_true("('hello'):gsub('l', {l = 'L'}) == 'heLLo' and ('hello'):gsub('l', {}) == 'hello'"));
  CHECK(is_true("('a1b2'):gsub('%d', function(d) return d * 2 end) == 'a2b4'"));
  CHECK(is_true("('abc'):gsub('%w', '%0%%', 2) == 'a%b%c' and ('aaa'):gsub('^a', 'b') == 'baa'"));
  CHECK_THAT(error_of("scenario{};\n('a'):gsub('a', '%2')"), Catch::Contains("no such capture"));
  CHECK_THAT(error_of("scenario{};\n('a'):gsub('a', function() return {} end)"), Catch::Contains("got a table"));
}

TEST_CASE("Malformed patterns say what is wrong") {
  const auto [pattern, problem] = GENERATE(table<std::string, std::string>({{"[a", "missing ']'"},
                                                                            {"a%", "ends with '%'"},
                                                                            {"(a", "unfinished capture"},
                                                                            {"(a))", "closes nothing"},
                                                                            {"%1", "invalid capture index %1"},
                                                                            {"%b", "missing arguments to '%b'"},
                                                                            {"%fa", "missing '['"}}));
  CHECK_THAT(error_of("scenario{};\n('a'):find('" + pattern + "')"), Catch::Contains(problem));
}

TEST_CASE("Matching takes no more steps than it is given") {
  std::uint64_t steps = 1000;
  const Pattern pattern = compile_pattern("a*a*a*b", true);
  CHECK_THROWS_AS(find_match(pattern, std::string(100, 'a'), 0, steps), PatternError);
  steps = 1000;
  CHECK(find_match(pattern, "aaab", 0, steps)->end == 4);
  CHECK(steps < 1000);
}
