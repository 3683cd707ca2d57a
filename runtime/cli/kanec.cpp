// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/kanec.hpp"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "generator/pipeline.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/base/temporary.hpp"
#include "runtime/base/text.hpp"
#include "runtime/cli/commands.hpp"
#include "runtime/terminal/interrupt.hpp"
#include "runtime/terminal/output.hpp"

namespace kanec::cli {
namespace {

constexpr auto overview = R"(kanec: from a tree of rigid bodies to a flat C++ solver of its equations of motion.

  scene      a TOML file (models/README.md) or a connection array: a tree of bodies, their numbers, their loads
  derive     Kane's equations of that tree, symbolically, block by block
  generate   these as a straight-line program, its operations counted, emitted as one C++ header
  simulate   that header compiled, kept in a cache, loaded, and integrated
  check      the compiled functions against a generic numeric path and against 50-digit arithmetic
)";

constexpr auto epilogue = R"(Begin with:
  kanec derive --connection 0,1,2,2,1,5      the source's six bodies, all symbols
  kanec simulate models/six_body             ten seconds of them, with a closing summary
  kanec simulate --help                      every command teaches by an example

Exit status: 0 done; 1 a check failed; 2 refused, with one message on standard error; 3 a mistake in kanec itself.)";

constexpr auto out_of_memory = "out of memory: found a task for which there is not enough; allowed: a smaller one";

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
  const std::string near = nearest(word.substr(0, word.find('=')), known);
  return near.empty() ? "" : " (did you mean " + near + "?)";
}

// What stands on the command line and has no meaning there.
std::string not_understood(const CLI::App& app, const std::string& word) {
  const auto chosen = app.get_subcommands();
  const bool is_option = word.size() > 1 && word[0] == '-';
  if (chosen.empty() && !is_option) return "no command '" + word + "'" + suggestion(word, command_names(app));
  const CLI::App& place = chosen.empty() ? app : *chosen.front();
  if (is_option) return "no option '" + word + "' here" + suggestion(word, option_names(place));
  return "one argument too many: '" + word + "'";
}

std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<std::string> rest = app.remaining(true);
  const auto chosen = app.get_subcommands();
  std::string text = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) && !rest.empty()) text = not_understood(app, rest.front());
  return text + "; see kanec " + (chosen.empty() ? "" : chosen.front()->get_name() + " ") + "--help";
}

void add_commands(CLI::App& app, Action& action) {
  add_derive(app, action);
  add_generate(app, action);
  add_simulate(app, action);
  add_check(app, action);
  add_eval(app, action);
  add_functions_command(app, action);
  add_bench(app, action);
  add_ledger(app, action);
  add_report(app, action);
}

int parse_and_act(int argc, char** argv) {
  CLI::App app(overview, "kanec");
  app.footer(epilogue);
  app.set_version_flag("--version", "kanec " + version());
  app.option_defaults()->take_last();  // so that defaults in a script can be overruled
  app.get_formatter()->column_width(34);
  Action action;
  add_commands(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    std::ostringstream text;
    app.exit(asked, text, text);
    print(text.str());
    return success;
  } catch (const CLI::ParseError& error) {
    remark(usage_error(app, error));
    return refused;
  }
  if (action) return action();
  remark(
      "a command is needed: derive, generate, simulate, check, eval, functions, bench, ledger or report; see kanec "
      "--help");
  return refused;
}

// Programs that kanec starts put files of their own there, and take what begins like an option for one.
void make_temporary_folder_absolute() {
  const char* folder = std::getenv("TMPDIR");
  if (folder != nullptr && folder[0] != '/') ::setenv("TMPDIR", temporary_root().c_str(), 1);
}

// Where memory ends while an exception is under way, or in a destructor, nothing can be caught any more.
[[noreturn]] void tell_and_end() {
  const std::exception_ptr error = std::current_exception();
  try {
    if (error) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    remark(out_of_memory);
    std::_Exit(refused);
  } catch (...) {
  }
  std::abort();
}

}  // namespace

int run(int argc, char** argv) noexcept {
  std::set_terminate(tell_and_end);
  try {
    guard_standard_streams();
    make_temporary_folder_absolute();
    return parse_and_act(argc, argv);
  } catch (const Interrupted& interruption) {
    remark(interruption.what());
    return interrupted;
  } catch (const InternalError& error) {
    remark(std::string("a mistake in kanec itself: ") + error.what());
  } catch (const Error& error) {
    remark_lines(error.what());
    return refused;
  } catch (const std::filesystem::filesystem_error& error) {
    remark(error.path1().string() + ": " + error.code().message());
    return refused;
  } catch (const std::system_error& error) {
    remark(error.what());
    return refused;
  } catch (const std::bad_alloc&) {
    remark(out_of_memory);
    return refused;
  } catch (const std::length_error&) {
    remark(out_of_memory);
    return refused;
  } catch (const std::exception& error) {
    remark(std::string("unexpected: ") + error.what());
  } catch (...) {
    remark("unexpected error");
  }
  return unexpected;
}

}  // namespace kanec::cli
