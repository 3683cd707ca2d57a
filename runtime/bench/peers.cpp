// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/bench/peers.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <array>

#include "runtime/base/error.hpp"
#include "runtime/terminal/output.hpp"

namespace kanec {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& library) {
  const char* cause = ::dlerror();
  throw LoadError(library.string() + ": " + (cause != nullptr ? cause : "cause unknown"));
}

std::unique_ptr<void, void (*)(void*)> created(const kanec_peer& peer, const kanec_peer_model& model,
                                               std::size_t n_slots) {
  std::array<char, 500> message{};
  void* simulation = peer.create(&model, static_cast<int32_t>(n_slots), message.data(), message.size());
  if (simulation == nullptr) throw NotModelled(message.data());
  return {simulation, peer.destroy};
}

}  // namespace

Peer::Peer(const fs::path& library)
    : handle_(::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL), [](void* handle) {
        if (handle != nullptr) ::dlclose(handle);
      }) {
  if (!handle_) fail(library);
  const auto entry = reinterpret_cast<kanec_peer_entry_function>(::dlsym(handle_.get(), KANEC_PEER_ENTRY));
  if (entry == nullptr) fail(library);
  peer_ = entry();
  if (peer_->abi_version != KANEC_PEER_ABI_VERSION || peer_->struct_size != sizeof(kanec_peer))
    throw LoadError(library.string() + ": made for another kanec");
}

std::vector<Peer> peers_beside_program() {
  std::error_code ignored;
  const fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path() / "peers";
  std::vector<fs::path> libraries;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".so") libraries.push_back(entry.path());
  std::sort(libraries.begin(), libraries.end());
  std::vector<Peer> peers;
  for (const fs::path& library : libraries) {
    try {
      peers.emplace_back(library);
    } catch (const LoadError& error) {
      remark(std::string("note: ") + error.what());
    }
  }
  return peers;
}

PeerSimulation::PeerSimulation(const Peer& peer, const RelativeModel& model, const std::vector<RelativeState>& states)
    : functions_(&peer.functions()),
      n_q_(static_cast<std::size_t>(model.n_q)),
      n_u_(static_cast<std::size_t>(model.n_u)),
      simulation_(created(*functions_, model.view(), states.size())) {
  for (std::size_t i = 0; i < states.size(); ++i)
    functions_->set(simulation_.get(), static_cast<int32_t>(i), states[i].q.data(), states[i].u.data(),
                    states[i].force.data());
}

std::vector<double> PeerSimulation::result(std::size_t state) {
  std::vector<double> rates(n_u_);
  accelerate(state);
  functions_->result(simulation_.get(), rates.data());
  return rates;
}

PeerMotion PeerSimulation::integrate(std::size_t state, int integrator, double fineness, std::span<const double> times,
                                     double limit) {
  std::vector<double> q(n_q_ * times.size()), u(n_u_ * times.size());
  const kanec_peer_run run = {integrator, static_cast<int32_t>(state),        fineness,
                              limit,      static_cast<int32_t>(times.size()), times.data()};
  kanec_peer_motion motion = {q.data(), u.data(), 0.0, 0, 0, 0};
  std::array<char, 500> message{};
  if (functions_->integrate(simulation_.get(), &run, &motion, message.data(), message.size()) != 0)
    throw IntegrationError(message.data());
  PeerMotion result{{}, motion.seconds, motion.steps, motion.evaluations, motion.is_late != 0};
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double *at_q = q.data() + i * n_q_, *at_u = u.data() + i * n_u_;
    result.states.push_back({{at_q, at_q + n_q_}, {at_u, at_u + n_u_}, {}});
  }
  return result;
}

}  // namespace kanec
