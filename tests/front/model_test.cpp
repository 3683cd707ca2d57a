// Compiled models by the front door: evaluated one by one and in batches, loaded from files, refused where they do not
// fit.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <fstream>
#include <limits>

#include "kanec/abi.h"
#include "tests/front/bench.hpp"

namespace kanec::test {
namespace {

using testing::HasSubstr;

class FrontModel : public testing::Test {
 protected:
  Scene scene = shipped("cart_pole");
  Emission emission{.functions = {"accelerations", "forcing", "mass_matrix", "residual", "energy"}};
  Model model = scene.compile(emission, shared_cache());
};

// Oracle: the equations of a cart of mass M with a pole, solved by hand at rest and upright: the cart moves by
// push / M_eff only where the pole's mass is counted in.
TEST_F(FrontModel, evaluates_by_name_with_parameters_and_inputs) {
  Evaluator at(model);
  const std::vector<double> x = {0.3, 0.1}, y = {0.5, -0.2};
  const std::vector<double> ydot = at.evaluate("accelerations", {.x = x, .y = y});
  const std::vector<double> f = at.evaluate("forcing", {.x = x, .y = y}), A = at.evaluate("mass_matrix", {.x = x});
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(A[2 * i] * ydot[0] + A[2 * i + 1] * ydot[1], f[i], 1e-12);
  at.set_input("push", 2.0);
  const std::vector<double> pushed = at.evaluate("forcing", {.x = x, .y = y});
  EXPECT_NEAR(pushed[1] - f[1], 2.0, 1e-12);
  for (const double r :
       at.evaluate("residual", {.x = x, .y = y, .ydot = at.evaluate("accelerations", {.x = x, .y = y})}))
    EXPECT_NEAR(r, 0, 1e-12);
}

TEST_F(FrontModel, tells_what_its_functions_read) {
  const Function energy = model.function("energy"), residual = model.function("residual");
  EXPECT_TRUE(energy.reads_x && energy.reads_y);
  EXPECT_FALSE(energy.reads_ydot || energy.reads_inputs || energy.reads_t);
  EXPECT_TRUE(residual.reads_ydot && residual.reads_inputs);
  EXPECT_EQ(model.inputs()[0].name, "push");
  EXPECT_EQ(model.coordinates(), (std::vector<std::string>{"theta_pole", "s_cart"}));
}

TEST_F(FrontModel, refuses_sizes_names_and_numbers) {
  Evaluator at(model);
  const std::vector<double> x = {0.3, 0.1}, y = {0.5, -0.2}, three(3);
  std::vector<double> out(2);
  const Function accelerations = model.function("accelerations");
  EXPECT_THAT(refusal<InputError>([&] { at.evaluate(accelerations, {.x = three, .y = y}, out); }),
              HasSubstr("accelerations: x: found 3 numbers; allowed: 2"));
  EXPECT_THROW(at.evaluate(accelerations, {.x = x}, out), InputError);
  EXPECT_THROW(at.evaluate(accelerations, {.x = x, .y = y}, std::span(out).first(1)), InputError);
  EXPECT_THAT(refusal<InputError>([&] { (void)at.evaluate("acelerations", {.x = x, .y = y}); }),
              HasSubstr("did you mean accelerations?"));
  EXPECT_THAT(refusal<InputError>([&] { at.set_input("puhs", 1); }), HasSubstr("allowed: push (did you mean push?)"));
  EXPECT_THROW(at.set_input("push", std::numeric_limits<double>::quiet_NaN()), InputError);
  EXPECT_THROW(at.set_inputs(three), InputError);
  Function foreign = accelerations;
  foreign.number = 99;
  EXPECT_THROW(at.evaluate(foreign, {.x = x, .y = y}, out), InputError);
  EXPECT_THROW(simulate(at, three, y, {}), InputError);
  const std::vector<double> nan = {std::nan(""), 0};
  EXPECT_THAT(refusal<InputError>([&] { simulate(at, nan, y, {}); }), HasSubstr("x: found nan"));
}

TEST_F(FrontModel, a_copy_of_an_evaluator_has_its_own_values) {
  Evaluator a(model);
  Evaluator b = a;
  b.set_input("push", 7);
  EXPECT_EQ(a.inputs()[0], 0.0);
  EXPECT_EQ(b.inputs()[0], 7.0);
}

class FrontBatch : public FrontModel {
 protected:
  static constexpr int count = 1001;
  std::vector<double> x, y;
  FrontBatch() {
    for (int j = 0; j < count; ++j) {
      x.insert(x.end(), {0.01 * j, -0.02 * j});
      y.insert(y.end(), {std::sin(j), std::cos(j)});
    }
  }
};

// Oracle: one state at a time, up to rounding; and both orders to the bit.
TEST_F(FrontBatch, evaluates_many_states_in_either_order) {
  Batch batch = scene.compile_batch(emission, shared_cache(), 2);
  const Function accelerations = batch.model().function("accelerations");
  std::vector<double> out(2 * count), by_entry(2 * count);
  batch.evaluate(accelerations, {.count = count, .x = x, .y = y}, std::span<double>(out));
  const Evaluator one(model);
  for (std::size_t j = 0; j < count; ++j) {
    const std::vector<double> alone =
        one.evaluate("accelerations", {.x = std::span(x).subspan(2 * j, 2), .y = std::span(y).subspan(2 * j, 2)});
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(out[2 * j + i], alone[i], 1e-13 * (1 + std::fabs(alone[i])));
  }
  std::vector<double> xt(x.size()), yt(y.size());
  for (std::size_t j = 0; j < count; ++j)
    for (std::size_t i = 0; i < 2; ++i) {
      xt[i * count + j] = x[2 * j + i];
      yt[i * count + j] = y[2 * j + i];
    }
  batch.evaluate(accelerations, {.count = count, .order = Order::entries, .x = xt, .y = yt},
                 std::span<double>(by_entry));
  for (std::size_t j = 0; j < count; ++j)
    for (std::size_t i = 0; i < 2; ++i) ASSERT_EQ(by_entry[i * count + j], out[2 * j + i]);
}

TEST_F(FrontBatch, takes_inputs_and_parameters_a_state) {
  Batch batch = scene.compile_batch(emission, shared_cache(), 1);
  const Function forcing = batch.model().function("forcing");
  std::vector<double> push(count), out(2 * count), without(2 * count);
  for (std::size_t j = 0; j < count; ++j) push[j] = static_cast<double>(j);
  batch.evaluate(forcing, {.count = count, .x = x, .y = y}, std::span<double>(without));
  batch.evaluate(forcing, {.count = count, .x = x, .y = y, .inputs = push}, std::span<double>(out));
  for (std::size_t j = 0; j < count; ++j) EXPECT_NEAR(out[2 * j + 1] - without[2 * j + 1], push[j], 1e-11);
  batch.set_input("push", 3);
  batch.evaluate(forcing, {.count = count, .x = x, .y = y}, std::span<double>(out));
  EXPECT_NEAR(out[1] - without[1], 3, 1e-11);
}

TEST_F(FrontBatch, refuses_what_does_not_fit) {
  Batch batch = scene.compile_batch(emission, shared_cache(), 1);
  const Function accelerations = batch.model().function("accelerations");
  std::vector<double> out(2 * count);
  const std::span<double> to(out);
  EXPECT_THAT(refusal<InputError>([&] { batch.evaluate(accelerations, {.count = count + 1, .x = x, .y = y}, to); }),
              HasSubstr("x: found 2002 numbers; allowed: 1002 times 2"));
  EXPECT_THROW(batch.evaluate(accelerations, {.count = -1, .x = x, .y = y}, to), InputError);
  EXPECT_THROW(batch.evaluate(accelerations, {.count = count, .x = x}, to), InputError);
  const std::vector<float> few(2);
  std::vector<float> result(2);
  EXPECT_THROW(batch.evaluate(accelerations, {.count = 1, .x = few, .y = few}, std::span<float>(result)), InputError);
  EXPECT_THROW(Evaluator(batch.model()), InputError);
  EXPECT_THROW(scene.compile_batch(emission, shared_cache(), 1, "half"), InputError);
  EXPECT_THROW(scene.compile_batch(emission, shared_cache(), 1, "double", 3), InputError);
  batch.evaluate(accelerations, {}, std::span<double>());
}

TEST_F(FrontBatch, of_float_takes_float) {
  Batch batch = scene.compile_batch(emission, shared_cache(), 1, "float");
  EXPECT_TRUE(batch.is_float());
  const std::vector<float> xf = {0.3f, 0.1f}, yf = {0.5f, -0.2f};
  std::vector<float> out(2);
  batch.evaluate(batch.model().function("accelerations"), {.count = 1, .x = xf, .y = yf}, std::span<float>(out));
  const std::vector<double> xd(xf.begin(), xf.end()), yd(yf.begin(), yf.end());
  const std::vector<double> wanted = Evaluator(model).evaluate("accelerations", {.x = xd, .y = yd});
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(static_cast<double>(out[i]), wanted[i], 1e-5 * (1 + std::fabs(wanted[i])));
}

// Where the cache holds the compiled model of this scene, and of nothing else.
std::filesystem::path library_of(const Scene& scene, const std::filesystem::path& folder, bool batch) {
  Compilation compilation;
  compilation.cache = folder;
  if (batch)
    scene.compile_batch({.functions = {"accelerations"}}, compilation, 1);
  else
    scene.compile({.functions = {"accelerations"}}, compilation);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().filename() == "model.so") return entry.path();
  return "";
}

TEST_F(FrontModel, is_loaded_from_a_library) {
  const Folder folder;
  const std::filesystem::path library = library_of(scene, folder.path() / "cache", false);
  const Model loaded = Model::load(library);
  EXPECT_EQ(loaded.name(), "cart_pole");
  const std::vector<double> x = {0.3, 0.1}, y = {0.5, -0.2};
  EXPECT_EQ(Evaluator(loaded).evaluate("accelerations", {.x = x, .y = y}),
            Evaluator(model).evaluate("accelerations", {.x = x, .y = y}));
  EXPECT_THAT(refusal<LoadError>([&] { Batch::load(library); }), HasSubstr("found a model; allowed: a batch"));
  const Folder other;
  const std::filesystem::path batch = library_of(scene, other.path() / "cache", true);
  EXPECT_EQ(Batch::load(batch, 1).model().name(), "cart_pole");
  EXPECT_THAT(refusal<LoadError>([&] { Model::load(batch); }), HasSubstr("found a batch; allowed: a model"));
}

TEST_F(FrontModel, is_not_loaded_from_what_is_none) {
  const Folder folder;
  const std::filesystem::path library = library_of(scene, folder.path() / "cache", false);
  EXPECT_THROW(Model::load(folder.path() / "none.so"), FileError);
  EXPECT_THROW(Model::load(folder.path()), FileError);
  std::ofstream(folder.path() / "text.so") << "no library";
  EXPECT_THAT(refusal<FileError>([&] { Model::load(folder.path() / "text.so"); }), HasSubstr("no shared library"));
  for (const std::uintmax_t divisor : {2u, 10u, 100u}) {
    const std::filesystem::path cut = folder.path() / "cut.so";
    std::filesystem::copy_file(library, cut, std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(cut, std::filesystem::file_size(library) / divisor);
    EXPECT_THROW(Model::load(cut), FileError) << divisor;
  }
}

// The version stands in the library's data, before the size of its description.
TEST_F(FrontModel, of_another_abi_version_is_not_loaded) {
  const Folder folder;
  const std::filesystem::path library = library_of(scene, folder.path() / "cache", false);
  std::ifstream file(library, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(file)), {});
  const std::uint32_t mark[2] = {KANEC_ABI_VERSION, sizeof(kanec_model)};
  const std::size_t at = bytes.find(std::string(reinterpret_cast<const char*>(mark), sizeof(mark)));
  ASSERT_NE(at, bytes.npos);
  bytes[at] = static_cast<char>(KANEC_ABI_VERSION - 1);
  const std::filesystem::path old = folder.path() / "old.so";
  std::ofstream(old, std::ios::binary) << bytes;
  EXPECT_THAT(refusal<LoadError>([&] { Model::load(old); }), HasSubstr("ABI version is 4, expected 5"));
}

}  // namespace
}  // namespace kanec::test
