// A compiled model: loaded, asked for its names and sizes, evaluated in one state. Not: many states (batch.hpp), nor
// how it is made of a scene (scene.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kanec/error.hpp"
#include "kanec/export.hpp"

struct kanec_model;

namespace kanec {

// A parameter or an input.
struct Quantity {
  std::string name;
  double value = 0.0;
};

// A function of a model, by which it is called. A combined one is named "kinematics_and_accelerations"; its results
// stand one after another.
struct Function {
  std::string name;
  int size = 0;  // numbers of a result; matrices stand row by row
  bool reads_t = false, reads_x = false, reads_y = false, reads_ydot = false, reads_inputs = false;
  int number = 0;  // among the model's
};

// Where a function is evaluated. What it does not read may be empty; what it reads has nx, ny, ny numbers.
struct StateView {
  double t = 0.0;                  // [s]
  std::span<const double> x = {};  // coordinates: Euler parameters (scalar last), angles [rad], translations [m]
  std::span<const double> y =
      {};  // speeds: absolute angular velocities in body axes, rates of angles [rad/s], of translations [m/s]
  std::span<const double> ydot = {};
};

// Cheap to copy: copies share the library, which stays loaded as long as one of them, or an Evaluator of one, lives.
// All functions may be called from several threads at once.
class KANEC_API Model {
 public:
  // A shared library of `kanec generate --abi` and abi.h, or of a cache. Throws FileError where there is no whole
  // library, LoadError where it is no model, or one of another ABI version.
  static Model load(const std::filesystem::path& library);
  // A model that something else keeps loaded, at least as long as `owner`.
  Model(const kanec_model& model, std::shared_ptr<const void> owner);

  std::string name() const;
  std::string hash() const;  // of scene, generator and options: 16 hexadecimal digits
  int n_bodies() const;
  int nx() const;
  int ny() const;
  std::vector<std::string> coordinates() const;  // (nx) "theta_3"
  std::vector<std::string> speeds() const;       // (ny) "thetadot_3"
  // Those that its functions read, with their defaults.
  std::vector<Quantity> parameters() const;
  std::vector<Quantity> inputs() const;
  // The same with other defaults; what its functions do not read is left out. Throws InputError for what is not finite.
  Model with(const std::vector<Quantity>& values) const;
  std::vector<Function> functions() const;
  bool has(std::string_view function) const;
  // "accelerations"; "kinematics+accelerations" as well as "kinematics_and_accelerations". Throws InputError, which
  // names the nearest.
  Function function(std::string_view name) const;

  const kanec_model& abi() const { return *model_; }

 private:
  const kanec_model* model_;
  std::shared_ptr<const void> owner_;
  std::vector<Quantity> parameters_, inputs_;
};

// A model with values of its parameters and inputs. evaluate() may be called from several threads at once while none
// calls a function that is not const. Copies have their own values.
class KANEC_API Evaluator {
 public:
  // With the model's defaults.
  explicit Evaluator(Model model);
  Evaluator(const Evaluator& other);
  Evaluator& operator=(const Evaluator& other);
  Evaluator(Evaluator&&) noexcept;
  Evaluator& operator=(Evaluator&&) noexcept;
  ~Evaluator();

  const Model& model() const { return model_; }
  std::span<const double> parameters() const;
  std::span<const double> inputs() const;
  // Throw InputError for another number of values, a name that the model does not have, and what is not finite.
  void set_parameters(std::span<const double> values);
  void set_inputs(std::span<const double> values);
  void set_parameter(std::string_view name, double value);
  void set_input(std::string_view name, double value);

  // Into out (function.size). Throws InputError for arguments of another size, none of which is read then.
  void evaluate(const Function& function, const StateView& state, std::span<double> out) const;
  std::vector<double> evaluate(std::string_view function, const StateView& state) const;

  struct Data;
  const Data& data() const { return *data_; }

 private:
  Model model_;
  std::unique_ptr<Data> data_;
};

}  // namespace kanec
