// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/signature.hpp"

namespace kanec::emit {

std::string parameter_list(const Signature& signature, const Reads& reads) {
  std::string list;
  const auto append = [&list](bool wanted, bool read, const std::string& parameter) {
    if (wanted) list += (read ? "" : "[[maybe_unused]] ") + parameter + ", ";
  };
  append(true, reads.prepared, "const Prepared<T>& c");
  append(signature.x, reads.x, "const T* x");
  append(signature.y, reads.y, "const T* y");
  append(signature.ydot, reads.ydot, "const T* ydot");
  append(signature.inputs, reads.inputs, "const Inputs<T>& u");
  return list + "T* " + signature.out;
}

std::string argument_list(const Signature& signature, const std::string& prepared, const std::string& inputs,
                          const std::string& out) {
  std::string list = prepared;
  if (signature.x) list += ", x";
  if (signature.y) list += ", y";
  if (signature.ydot) list += ", ydot";
  if (signature.inputs) list += ", " + inputs;
  return list + ", " + out;
}

}  // namespace kanec::emit
