// kanec generate: the emitted header as a file, in C++ or in C.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <deque>
#include <filesystem>
#include <optional>

#include "generator/pipeline.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/base/fit.hpp"
#include "runtime/cli/arguments.hpp"
#include "runtime/cli/commands.hpp"
#include "runtime/cli/scene_argument.hpp"
#include "runtime/model/dump.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/model/products.hpp"
#include "runtime/model/scene_files.hpp"
#include "runtime/run/needed_functions.hpp"
#include "runtime/terminal/output.hpp"

namespace kanec::cli {
namespace {

namespace fs = std::filesystem;

constexpr auto generate_footer = R"(Example: six_body.hpp, and a program that uses it
  kanec generate models/six_body -o .
  cat > fall.cpp <<'EOF'
  #include <cstdio>
  #include "six_body.hpp"
  int main() {
    namespace model = kanec::six_body;
    const auto prepared = model::prepare(model::Parameters<double>{});
    double x[model::nx] = {}, y[model::ny] = {}, ydot[model::ny];
    for (int k = 0; k < model::n_bodies; ++k) x[4 * k + 3] = 1.0;  // eps = (0, 0, 0, 1)
    model::accelerations(prepared, x, y, model::Inputs<double>{}, ydot);
    std::printf("%.17g\n", ydot[20]);  // third component of the rate of sdot_1
  }
  EOF
  g++ -O2 fall.cpp && ./a.out

The header needs nothing but a C++17 compiler; with --language c, <name>.h, nothing but C99 and <math.h>, in double or with
KANEC_REAL defined as float: docs/embed_c.md. With --abi the two files that `kanec simulate` compiles beside it are
written as well; with --taylor <name>_taylor.hpp, which has the Taylor series of the motion: what --integrator taylor
steps by. --dump prints one stage of the pipeline instead: scene, equations, program, ledger, header, abi.)";

struct GenerateArguments {
  SceneArgument scene;
  std::vector<std::string> functions;
  std::optional<symbolic::Algorithm> algorithm;
  std::string output;
  std::string stage;
  std::string depfile;
  emit::Optimize optimize = emit::Optimize::speed;
  emit::Language language = emit::Language::cpp;
  bool abi = false;
  bool taylor = false;
  bool json = false;
};

// A file that is announced, so that an unwritable one is known, before there is anything to write.
struct Product {
  fs::path path;
  AtomicFile file;
  std::size_t bytes = 0;

  explicit Product(const fs::path& path_) : path(path_), file(path_) {}
  void write(const std::string& text) {
    file.write(text);
    bytes = text.size();
  }
};

Products products_of(const GenerateArguments& options) {
  const Products products{options.language, options.abi, options.taylor};
  check_products(products);
  if (options.language == emit::Language::c && !options.stage.empty())
    throw InputError("--language c: found it beside --dump " + options.stage +
                     "; allowed: --language cpp, since stages before the header have no language; -o - prints it");
  return products;
}

bool means_folder(const std::string& output) {
  std::error_code ignored;
  return output.empty() || output.back() == '/' || fs::is_directory(output, ignored);
}

// A folder that is made for the products, and goes again where there are none.
class NewFolder {
 public:
  explicit NewFolder(const std::string& output) {
    std::error_code error;
    if (output.size() < 2 || output.back() != '/' || fs::exists(output, error)) return;
    const fs::path path(output.substr(0, output.size() - 1));
    if (!fs::create_directory(path, error)) throw FileError(output, error.message());
    path_ = path;
  }
  ~NewFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove(path_, ignored);  // only where it is empty
  }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

 private:
  fs::path path_;
};

std::deque<Product> open_products(const GenerateArguments& options, const Products& wanted, const std::string& name) {
  std::deque<Product> products;
  if (options.json && is_standard_output(options.output))
    throw InputError("--json: found it beside --output " + options.output +
                     "; allowed: one of them on standard output");
  const std::vector<std::string> names = product_names(name, wanted);
  if (means_folder(options.output)) {
    for (const std::string& file : names) products.emplace_back(fs::path(options.output) / file);
    return products;
  }
  if (names.size() > 1)
    throw InputError("--output: found the file '" + options.output + "'; allowed with " +
                     (options.abi ? "--abi" : "--taylor") + ": a folder, since the files include " + name +
                     ".hpp by that name");
  products.emplace_back(options.output);
  return products;
}

// As make reads it.
std::string escaped_for_make(const std::string& path) {
  std::string text;
  for (const char c : path) text += c == ' ' || c == '#' ? std::string("\\") + c : c == '$' ? "$$" : std::string(1, c);
  return text;
}

// Which files the products are made of.
std::string rule_of(const std::deque<Product>& products, const SceneArgument& scene) {
  std::string text;
  for (const Product& product : products) text += (text.empty() ? "" : " ") + escaped_for_make(product.path.string());
  text += ":";
  return (scene.path.empty() ? text : text + " " + escaped_for_make(scene_file(scene.path))) + "\n";
}

void write(std::deque<Product>& products, const std::vector<std::string>& texts, AtomicFile* rule) {
  for (std::size_t i = 0; i < texts.size(); ++i) products[i].write(texts[i]);
  std::vector<AtomicFile*> files;
  for (Product& product : products) files.push_back(&product.file);
  if (rule != nullptr) files.push_back(rule);
  commit_all(files);
}

std::string report_text(const scene::Scene& scene, const Generated& generated, const std::deque<Product>& products) {
  std::string text =
      fmt::format("{}: {}, {}, {}, {}, {}; model {}\n\n", scene.name, counted(scene.bodies.size(), "body", "bodies"),
                  counted(static_cast<std::size_t>(n_coordinates(scene)), "coordinate", "coordinates"),
                  counted(static_cast<std::size_t>(n_speeds(scene)), "speed", "speeds"),
                  counted(scene.parameters.size(), "parameter", "parameters"),
                  counted(scene.inputs.size(), "input", "inputs"), generated.hash);
  text += ledger_text(generated.program) + "\n";
  for (const Product& product : products)
    text += fmt::format("wrote {} ({} bytes)\n", fit::line(product.path.string()), product.bytes);
  return text;
}

Json report_json(const scene::Scene& scene, const Generated& generated, const std::deque<Product>& products) {
  Json files = Json::array();
  for (const Product& product : products) files.push_back({{"path", product.path.string()}, {"bytes", product.bytes}});
  Json prepare = ledger_json(program::prepare_ledger(generated.program));
  return {{"model", scene.name},
          {"hash", generated.hash},
          {"version", version()},
          {"n_bodies", size(scene)},
          {"nx", n_coordinates(scene)},
          {"ny", n_speeds(scene)},
          {"n_parameters", scene.parameters.size()},
          {"n_inputs", scene.inputs.size()},
          {"functions", ledgers_json(generated.program)},
          {"prepare", std::move(prepare)},
          {"files", std::move(files)}};
}

int dump_stage(const GenerateArguments& options, const scene::Scene& scene, const std::vector<std::string>& functions) {
  AtomicFile file(options.output.empty() ? "-" : options.output);
  file.write(dump(scene, functions, options.stage));
  file.commit();
  return 0;
}

void remark_note(const std::string& note) { remark("note: " + note); }

std::vector<std::string> functions_of(const GenerateArguments& options, const scene::Scene& scene) {
  std::vector<std::string> chosen = Functions(scene).chosen(options.functions);
  return options.taylor ? functions_with_rates(scene, std::move(chosen), remark_note) : chosen;
}

int generate_files(const GenerateArguments& options) {
  const Products wanted = products_of(options);
  const scene::Scene scene = load(options.scene);
  const std::vector<std::string> functions = functions_of(options, scene);
  if (!options.stage.empty()) return dump_stage(options, scene, functions);
  const NewFolder folder(options.output);
  std::deque<Product> products = open_products(options, wanted, scene.name);
  GenerateOptions how{functions,      options.algorithm, options.optimize, emit::Model{}.longest_line,
                      options.taylor, remark_note};
  how.language = options.language;
  const Generated generated = generate(scene, how);
  std::optional<AtomicFile> rule;
  if (!options.depfile.empty()) {
    rule.emplace(options.depfile);
    rule->write(rule_of(products, options.scene));
  }
  write(products, product_texts(generated, wanted), rule ? &*rule : nullptr);
  if (options.json)
    print_json(report_json(scene, generated, products));
  else
    report(report_text(scene, generated, products), is_standard_output(options.output));
  return 0;
}

void add_language(CLI::App& command, emit::Language& language) {
  const auto set = [&language](const std::string& text) {
    language = text == "c" ? emit::Language::c : emit::Language::cpp;
  };
  command.add_option_function<std::string>("--language", set, "the header in C++17 (cpp, the default) or C99 (c)")
      ->check(CLI::IsMember({"cpp", "c"}))
      ->option_text("cpp|c");
}

}  // namespace

void add_generate(CLI::App& app, Action& action) {
  const auto [command, options] =
      add_command(app, action, "generate", "the emitted C++ or C header of a scene, with its operations counted",
                  generate_footer, &generate_files);
  add_scene(*command, options->scene);
  add_functions(*command, options->functions);
  add_algorithm(*command, options->algorithm);
  command
      ->add_option("-o,--output", options->output,
                   "folder of <name>.hpp or <name>.h (made where DIR/ is new), a file, or - (./)")
      ->option_text("DIR/|FILE|-");
  add_optimize(*command, options->optimize);
  add_language(*command, options->language);
  command->add_flag("--abi", options->abi, "also <name>_abi.cpp and abi.h, for a shared library");
  command->add_flag("--taylor", options->taylor, "also <name>_taylor.hpp, the Taylor series of the motion");
  command->add_option("--depfile", options->depfile, "a rule for make: which files the header is made of")
      ->option_text("FILE");
  command->add_option("--dump", options->stage, "print a stage instead")
      ->option_text("STAGE")
      ->check(CLI::IsMember(stage_names()));
  command->add_flag("--json", options->json, "report for machines");
}

}  // namespace kanec::cli
