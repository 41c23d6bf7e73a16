#include <catch2/catch.hpp>

#include "scene_text.h"

using namespace proofreel;
using Catch::Contains;
using Catch::StartsWith;

namespace {

/// Ends with the words expected: for a reason of its own, or because it took too many steps; never because it took too
/// long on the clock, which is the last resort.
void check_ends(const std::string& text, const std::string& expected) {
  const std::string error = error_of(text);
  CHECK_THAT(error, Contains(expected) && !Contains("seconds in one go"));
}

}  // namespace

TEST_CASE("A loop without end is stopped and named by its line") {
  CHECK_THAT(error_of("scenario{}\n\nwhile true do end"),
             StartsWith("scene.lua: line 3: the script was stopped after "));
  CHECK_THAT(error_of("scenario{}\nevery(0.1, function()\n  while true do end\nend)"),
             StartsWith("scene.lua: line 3: the script was stopped") && Contains("every, at 0.1 s"));
  CHECK_THAT(error_of("scenario{}\nmeasure('m', function() for i = 1, math.huge do end end)"),
             StartsWith("scene.lua: line 2: ") && Contains("measure \"m\""));
}

TEST_CASE("Timers that make timers of the same tick without end are stopped") {
  CHECK_THAT(error_of("scenario{}\nlocal function f() at(time(), f) end\nat(0.5, f)"), Contains("was stopped after"));
}

TEST_CASE("A script that fills the memory is stopped and named by its line") {
  CHECK_THAT(error_of("scenario{}\nlocal s = ('x'):rep(10000000000)"),
             Contains("scene.lua: line 2: resulting string too large"));
  CHECK_THAT(error_of("scenario{}\nlocal s = ('x'):rep(1000000000)"),
             Contains("scene.lua: line 2: the script needs more than 256 MB of memory"));
  CHECK_THAT(error_of("scenario{}\nlocal t = {}\nfor i = 1, 1e9 do\n  t[i] = {}\nend"),
             Contains("scene.lua: line 4: the script needs more than 256 MB of memory"));
  CHECK_THAT(error_of("scenario{}\nlocal s = 'x'\nwhile true do s = s .. s end"), Contains("line 3: the script needs"));
}

TEST_CASE("Things made outside Lua's memory are counted too") {
  CHECK_THAT(error_of("scenario{}\nwhile true do caption{text='x'} end"), Contains("was stopped after"));
  CHECK_THAT(error_of("scenario{}\nlocal s = circle{radius=1}\nwhile true do body{shape=s} end"),
             Contains("a scene holds at most 200000 bodies"));
}

TEST_CASE("Hostile patterns are refused by their steps") {
  const std::string hostile =
      GENERATE("string.find(('a'):rep(400), ('a*'):rep(8)..'b')", "('a'):rep(400):match(('a-'):rep(8)..'b')",
               "('a'):rep(400):gsub(('a?'):rep(30)..('a'):rep(30)..'b', '')",
               "for w in ('a'):rep(400):gmatch(('a*'):rep(8)..'b') do end", "('('):rep(1e6):find('%b()')",
               "('a'):rep(1e6):find(('a'):rep(5e5)..'b', 1, true)");
  check_ends("scenario{};\n" + hostile, "too many steps");
}

TEST_CASE("Loops inside library functions end") {
  CHECK(error_of("scenario{}\nassert(string.rep('', 1 << 60) == '')").empty());
  check_ends("scenario{}\nlocal s = ('x'):rep(1e6); local t = s:gsub('.*', ('%0'):rep(1e6))", "too long");
  check_ends("scenario{}\nlocal t = {}\nfor i = 1, 5e6 do t[i] = i end\nfor k in pairs(t) do end", "was stopped after");
  check_ends("scenario{}\nfor i = 1, 1e5 do body{shape=circle{radius=1}} energy() end", "was stopped after");
  check_ends("scenario{}\ntable.move({}, 1, 1 << 60, 2)", "was stopped after");
  check_ends("scenario{}\ntable.unpack({}, 1, 1e9)", "too many results to unpack");
  check_ends("scenario{}\ntable.concat({}, '', 1, 1 << 60)", "invalid value (nil) at index 1");
  check_ends("scenario{}\nlocal t = {}\nfor i = 1, 1e6 do t[i] = i end\nwhile true do table.insert(t, 1, 0) end",
             "was stopped after");
  check_ends("scenario{}\nlocal s = ('x'):rep(5e7)\nwhile true do s:upper() end", "was stopped after");
}

TEST_CASE("Recursion and nesting without end are errors, not crashes") {
  CHECK_THAT(error_of("scenario{}\nlocal function f() return 1 + f() end\nf()"), Contains("stack overflow"));
  CHECK_THAT(error_of("scenario{}\nlocal x = " + std::string(10000, '(') + "1"), Contains("overflow"));
  CHECK_THAT(error_of("scenario{}\nlocal t = {3, 2, 1}\ntable.sort(t, function() while true do end end)"),
             Contains("was stopped after"));
  CHECK_THAT(error_of("scenario{}\nstring.rep('x', 1):gsub('x', function() error('inside') end)"), Contains("inside"));
}

TEST_CASE("What could reach out of the sandbox is not there and says so") {
  const std::string name =
      GENERATE("os", "io", "debug", "coroutine", "require", "load", "dofile", "pcall", "setmetatable", "getmetatable",
               "collectgarbage", "rawset", "next", "_G", "utf8", "package");
  CHECK(is_true(name + " == nil"));
  CHECK_THAT(error_of("scenario{}\n" + name + "()"), Contains("scenarios are not offered \"" + name + "\""));
  CHECK_THAT(error_of("scenario{}\n" + name + ".x()"), Contains("scenarios are not offered \"" + name + "\""));
}

TEST_CASE("Bytecode is refused") {
  CHECK_THAT(error_of(std::string("\x1bLua\x54\0\x19\x93\r\n", 10)),
             Contains("a compiled file cannot be run: give its Lua source"));
  CHECK(is_true("string.dump == nil"));
}

TEST_CASE("A misspelt word is told what it was meant to be") {
  CHECK_THAT(error_of("scenario{}\nbody{shape=circel{radius=1}}"),
             Contains("line 2") && Contains("did you mean \"circle\"?"));
}

TEST_CASE("Errors of any kind have a place") {
  CHECK(error_of("scenario{}\nerror('too bad')") == "scene.lua: line 2: too bad");
  CHECK(error_of("scenario{}\nassert(false, 'wrong')") == "scene.lua: line 2: wrong");
  CHECK(error_of("scenario{}\nerror({})") == "scene.lua: line 2: error() was called with a table instead of a text");
  CHECK_THAT(error_of("scenario{}\nlocal x = = 1"), StartsWith("scene.lua: line 2: unexpected symbol"));
}

TEST_CASE("No address is ever printed") {
  CHECK(is_true("tostring({}) == 'table: 1'"));
  CHECK(is_true("tostring(print) == 'function: 1' and tostring(t) == 'table: 2' and tostring(t) == 'table: 2'",
                "t = {}"));
  CHECK(is_true("string.format('%s|%5.2s|%d', t, 'abc', 3) == 'table: 1|   ab|3'", "t = {}"));
  CHECK(is_true("tostring(circle{radius=1}) == 'shape' and tostring(world) == 'body \"world\"'"));
  CHECK_THAT(error_of("scenario{}\nstring.format('%p', {})"), Contains("%p is not offered"));
  CHECK_THAT(error_of("scenario{}\nlocal x = {} .. ''"), !Contains("0x"));
}
