// SPDX-License-Identifier: BSD-3-Clause
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <set>
#include <string_view>

#include "kanec_abi_text.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/base/text.hpp"
#include "runtime/compile/compile.hpp"
#include "runtime/compile/key.hpp"
#include "runtime/compile/library.hpp"

namespace kanec::compile {

namespace fs = std::filesystem;

// `folder` is there when nothing is kept; it outlives the library that is loaded from it.
struct Model::State {
  std::optional<TemporaryFolder> folder;
  Library library;
  fs::path path;
  bool from_cache = false;
  double seconds = 0.0;
  std::vector<std::string> notes;
};

Model::Model(std::unique_ptr<State> state) : state_(std::move(state)) {}
Model::~Model() = default;
Model::Model(Model&&) noexcept = default;
Model& Model::operator=(Model&&) noexcept = default;
const kanec_model& Model::abi() const { return state_->library.model(); }
const kanec_batch& Model::batch() const { return state_->library.batch(); }
bool Model::from_cache() const { return state_->from_cache; }
double Model::compile_seconds() const { return state_->seconds; }
const fs::path& Model::library() const { return state_->path; }
const std::vector<std::string>& Model::notes() const { return state_->notes; }

namespace {

constexpr char made_name[] = "made";  // in the workplace: what becomes the entry

struct Job {
  Source source;
  Compiler compiler;
  std::vector<std::string> chosen;  // of the options, behind those of the source
  std::vector<std::string> flags;
  Cache::Place place;
};

bool is_file_name(std::string_view name) {
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.-";
  return !name.empty() && name[0] != '.' && name[0] != '-' && name.find_first_not_of(allowed) == name.npos;
}

void check_names(const Source& source) {
  std::set<std::string> names = {"abi.h", made_name};  // ours
  for (const auto& [name, text] : source.files) {
    if (!is_file_name(name)) throw InternalError("unsound name of a source file: " + name);
    if (!names.insert(name).second) throw InternalError("source file given twice: " + name);
  }
  const auto is_main = [&source](const auto& file) { return file.first == source.main; };
  if (std::none_of(source.files.begin(), source.files.end(), is_main))
    throw InternalError("source file to compile is not given: " + source.main);
}

// Whether the file behind a path is a program of the machine's own, which says the same as long as it is the same, and
// no script, nor a link to a program that looks at what it was called by.
bool is_plain_program(const fs::path& path) {
  std::error_code failed;
  const fs::path real = fs::canonical(path, failed);
  for (const char* wrapper : {"ccache", "distcc", "icecc", "sccache"})
    if (failed || real.filename().string().find(wrapper) != std::string::npos) return false;
  std::ifstream file(real, std::ios::binary);
  std::array<char, 4> magic{};
  return file.read(magic.data(), magic.size()) && std::string_view(magic.data(), magic.size()) == "\177ELF";
}

// What a compiler says of itself takes longer to hear than to fetch a model: it is asked once.
std::string version_from(const std::optional<Cache>& cache, const Compiler& compiler) {
  if (!cache || !compiler.arguments.empty() || !is_plain_program(compiler.path)) return version_of(compiler);
  const std::string question = compiler.path.string() + " --version, " + file_behind(compiler.path);
  if (const std::string known = cache->recall(question); !known.empty()) return known;
  const std::string version = version_of(compiler);
  cache->remember(question, version);
  return version;
}

Job plan(const Source& source, const Options& options, const std::optional<Cache>& cache) {
  if (!is_identifier(source.name)) throw InternalError("model name is no identifier: " + source.name);
  Job job{source,
          locate_compiler(options.compiler, source.is_batch ? Code::lanes : Code::scalar),
          options.flags_given ? options.flags : default_flags(),
          {},
          {}};
  job.compiler.version = version_from(cache, job.compiler);
  return job;
}

// Where what is compiled of these files is kept, or, before there are files, of this origin.
void find_place(Job& job) {
  job.flags = job.source.flags;
  job.flags.insert(job.flags.end(), job.chosen.begin(), job.chosen.end());
  job.place = Cache::place(job.source.name, cache_key(job.source, job.compiler, job.flags));
}

std::string not_kept(const FileError& error) { return std::string("the compiled model is not kept: ") + error.what(); }

std::optional<Cache> open_cache(const Options& options, std::vector<std::string>& notes) {
  if (!options.use_cache) return std::nullopt;
  try {
    return Cache(options.cache.empty() ? default_cache() : options.cache);
  } catch (const FileError& error) {
    notes.push_back(not_kept(error));
    return std::nullopt;
  }
}

void note_once(std::vector<std::string>& notes, const std::string& note) {
  if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
}

// An entry that cannot be loaded, is not what its key says, or may have been written by others, counts as none, and
// goes. Another user's stays, and there is no cache then.
std::unique_ptr<Model::State> fetch(std::optional<Cache>& cache, const Job& job, std::vector<std::string>& notes) {
  if (!cache) return nullptr;
  const Finding found = cache->find(job.place);
  switch (found.kind) {
    case Finding::Kind::none:
      return nullptr;
    case Finding::Kind::sound:
      try {
        Library library(found.path, job.source, found.library);
        return std::make_unique<Model::State>(
            Model::State{std::nullopt, std::move(library), found.path, true, 0.0, notes});
      } catch (const LoadError&) {
        break;
      }
    case Finding::Kind::exposed:
      note_once(notes, found.path.string() + ": not read, because " + found.what + "; compiled anew");
      break;
    case Finding::Kind::foreign:
      notes.push_back(not_kept(FileError(found.path.string(), found.what + ", and is not read; remove it")));
      cache.reset();
      return nullptr;
  }
  try {
    cache->discard(job.place);
  } catch (const FileError&) {  // what cannot be removed is passed over each time
  }
  return nullptr;
}

TemporaryFolder with_sources(TemporaryFolder folder, const Source& source) {
  write_file(folder.path() / "abi.h", abi_text);
  for (const auto& [name, text] : source.files) write_file(folder.path() / name, text);
  const fs::path made = folder.path() / made_name;
  if (::mkdir(made.c_str(), 0700) != 0) throw FileError(made.string(), std::strerror(errno));
  return folder;
}

// The sources, laid out in the cache or, where that cannot be, in the system's temporary folder.
TemporaryFolder workplace(std::optional<Cache>& cache, const Job& job, std::vector<std::string>& notes) {
  if (cache) {
    try {
      return with_sources(cache->workplace(job.place), job.source);
    } catch (const FileError& error) {
      notes.push_back(not_kept(error));
      cache.reset();
    }
  }
  return with_sources(TemporaryFolder(temporary_root() / "kanec"), job.source);
}

std::unique_ptr<Model::State> make(const Job& job, TemporaryFolder folder) {
  const fs::path library = folder.path() / made_name / library_name;
  const double seconds = make_library(command_line(job.compiler, job.flags, folder.path() / job.source.main, library),
                                      library, folder.path());
  Library loaded(library, job.source);
  return std::make_unique<Model::State>(
      Model::State{std::move(folder), std::move(loaded), library, false, seconds, {}});
}

void keep(const Cache& cache, const Job& job, Model::State& state) {
  try {
    state.path = cache.store(state.path.parent_path(), job.place);
    state.folder.reset();
  } catch (const FileError& error) {
    state.notes.push_back(not_kept(error));
  }
}

// A second entry for the same library, found by what its files follow from. Only a saving: where it cannot be, nothing
// is lost.
void keep_by_origin(const Cache& cache, const Cache::Place& origin, const fs::path& library) {
  try {
    const TemporaryFolder folder = cache.workplace(origin);
    const fs::path made = folder.path() / made_name;
    if (::mkdir(made.c_str(), 0700) != 0) return;
    fs::copy_file(library, made / library_name);
    cache.store(made, origin);
  } catch (const FileError&) {
  } catch (const fs::filesystem_error&) {
  }
}

std::unique_ptr<Model::State> fetched_or_made(std::optional<Cache>& cache, const Job& job, const Options& options,
                                              std::vector<std::string>& notes) {
  if (auto state = fetch(cache, job, notes)) return state;
  const Waiting waiting{"which compiles the same model", options.tell, options.poll};
  const Lock lock = cache ? cache->lock(job.place, waiting) : Lock();
  if (auto state = fetch(cache, job, notes)) return state;  // made by another process meanwhile
  auto state = make(job, workplace(cache, job, notes));
  state->notes = notes;
  if (cache) keep(*cache, job, *state);
  return state;
}

}  // namespace

Model build(const Source& source, const Options& options) {
  std::vector<std::string> notes;
  std::optional<Cache> cache = open_cache(options, notes);
  Job job = plan(source, options, cache);
  std::optional<Cache::Place> origin;
  if (source.make) {
    if (cache && !source.origin.empty()) {
      find_place(job);
      if (auto state = fetch(cache, job, notes)) return Model(std::move(state));
      origin = job.place;
    }
    source.make(job.source);
  }
  check_names(job.source);
  find_place(job);
  auto state = fetched_or_made(cache, job, options, notes);
  if (cache && origin && !state->folder) keep_by_origin(*cache, *origin, state->path);
  return Model(std::move(state));
}

}  // namespace kanec::compile
