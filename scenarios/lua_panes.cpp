// The word `pane`: a split screen of scenes that differ in a few keys of `scenario{}`.

#include "scenarios/lua_fields.h"
#include "scenarios/lua_model.h"
#include "scenarios/lua_values.h"
#include "scenarios/lua_words.h"

namespace proofreel {
namespace {

constexpr std::size_t most_panes = 9;
constexpr lua_Unsigned longest_list = 100;

/// What makes all panes of one length and size belongs to the whole film: duration, fps, size, theme, golden.
constexpr Name pane_keys[] = {{"title"}, {"rate"},    {"seed"},   {"gravity"},
                              {"view"},  {"effects"}, {"layers"}, {"method"}};
constexpr const char* single_keys[] = {"rate", "seed", "gravity", "effects", "layers"};
constexpr Name view_keys[] = {{"center"}, {"height"}};
constexpr Name method_keys[] = {{"integrator"}, {"contact_solver"}, {"joint_solver"}, {"substeps"},
                                {"iterations"}, {"contact_hz"},     {"precision"}};

/// The value on top of the stack.
OverrideItem item_of(const Fields& fields, const char* key) {
  lua_State* state = fields.state();
  switch (lua_type(state, -1)) {
    case LUA_TBOOLEAN:
      return lua_toboolean(state, -1) != 0;
    case LUA_TSTRING:
      return text_to_show(state, -1, fields.word() + ": " + key);
    case LUA_TNUMBER:
      if (lua_isinteger(state, -1) != 0) return static_cast<std::int64_t>(lua_tointeger(state, -1));
      return lua_tonumber(state, -1);
    default:
      fields.refuse(key, "cannot be " + described(state, -1));
  }
}

/// Adds what the key holds, if it is there.
void read_override(const Fields& fields, const std::string& prefix, const char* key, PaneRecord& pane) {
  lua_State* state = fields.state();
  if (!fields.push(key)) return;
  charge_for_making(state);
  ParsedOverride value{
      prefix + key, sandbox_of(state).place(key) + "pane " + quote(pane.title), {}, lua_type(state, -1) == LUA_TTABLE};
  const lua_Unsigned count = value.is_list ? lua_rawlen(state, -1) : 0;
  if (count > longest_list) fields.refuse(key, "holds " + std::to_string(count) + " values: leave some out");
  for (lua_Unsigned i = 1; i <= count; ++i) {
    lua_rawgeti(state, -1, static_cast<lua_Integer>(i));
    value.items.push_back(item_of(fields, key));
    lua_pop(state, 1);
  }
  if (!value.is_list) value.items.push_back(item_of(fields, key));
  pane.overrides.push_back(std::move(value));
  lua_pop(state, 1);
}

/// The same for a table inside, whose keys are set one by one: what it leaves out stays as in `scenario{}`.
void read_table(const Fields& fields, const char* key, std::span<const Name> keys, PaneRecord& pane) {
  if (!fields.push(key)) return;
  const Fields inner(fields.state(), -1, std::string("pane: ") + key, keys);
  for (const Name& name : keys) read_override(inner, std::string(key) + ".", name.text, pane);
  lua_pop(fields.state(), 1);
}

PaneRecord read_pane(const Fields& fields) {
  PaneRecord pane{fields.required("title", fields.text("title")), {}};
  if (pane.title.empty()) fields.refuse("title", "must not be empty");
  for (const char* key : single_keys) read_override(fields, "", key, pane);
  read_table(fields, "view", view_keys, pane);
  read_table(fields, "method", method_keys, pane);
  return pane;
}

/// Returns whether this is the pane that is being made.
int pane(lua_State* state) {
  const Fields fields(state, 1, "pane", pane_keys);
  Model& model = model_of(state);
  model.must_load("pane");
  charge_for_making(state);
  PaneRecord pane = read_pane(fields);
  for (const PaneRecord& other : model.panes) {
    if (other.title == pane.title) fields.refuse("title", "is that of another pane, " + quote(pane.title));
  }
  if (model.panes.size() == most_panes) throw Problem("pane: a picture holds at most 9 panes");
  lua_pushboolean(state, model.panes.size() == model.pane ? 1 : 0);
  model.panes.push_back(std::move(pane));
  return 1;
}

}  // namespace

void open_panes(lua_State* state) {
  lua_pushglobaltable(state);
  set_word<pane>(state, "pane");
  lua_pop(state, 1);
}

}  // namespace proofreel
