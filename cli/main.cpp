#include <exception>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "golden/store.h"
#include "render/context.h"
#include "render/png.h"
#include "render/usage_error.h"

namespace proofreel {
namespace {

/// What the exit status says (the same for every subcommand).
enum Status { good = 0, failed = 1, wrong_use = 2, wrong_environment = 3 };

std::vector<Subcommand> add_commands(CLI::App& program) {
  std::vector<Subcommand> commands{
      list_command(program),    run_command(program),
#ifdef PROOFREEL_PICTURES
      render_command(program),
#endif
      check_command(program),   explain_command(program),
#ifdef PROOFREEL_PICTURES
      bless_command(program),   diff_command(program),         study_command(program),  scorecard_command(program),
      gallery_command(program), report_merge_command(program), doctor_command(program),
#endif
  };
  for (Subcommand& command : absent_commands(program)) commands.push_back(std::move(command));
  return commands;
}

int run(int argc, char** argv) {
  CLI::App program("Turns scripted scenes of rigid bodies into pictures and films, and proves they are still right.",
                   "proofreel");
  program.set_version_flag("--version", PROOFREEL_VERSION);
  program.footer(
      "Example: proofreel render pyramid -o pyramid.mp4\n"
      "Exit status: 0 good, 1 a check or expectation failed, 2 wrong use, a bad scenario or picture, 3 the "
      "environment");
  program.require_subcommand(1);
  const std::vector<Subcommand> commands = add_commands(program);
  refuse_empty_words({argv, static_cast<std::size_t>(argc)});
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? good : wrong_use;
  }
  for (const Subcommand& command : commands) {
    if (command.app->parsed()) return command.run();
  }
  return wrong_use;
}

}  // namespace
}  // namespace proofreel

int main(int argc, char** argv) {
  using namespace proofreel;
  try {
    return proofreel::run(argc, argv);
  } catch (const Interrupted& interrupted) {
    return interrupted.die();
  } catch (const EnvironmentError& error) {
    say(error.what());
    return wrong_environment;
  } catch (const UsageError& error) {
    say(error.what());
    return wrong_use;
  } catch (const ImageError& error) {
    say(error.what());
    return wrong_use;
  } catch (const ScenarioError& error) {
    say(error.what());
    return wrong_use;
  } catch (const std::bad_alloc&) {
    say("There is not enough memory for this: ask for smaller pictures or fewer bodies.");
    return wrong_environment;
  } catch (const std::exception& error) {
    say(std::string("Something unforeseen went wrong: ").append(error.what()));
    return wrong_environment;
  }
}
