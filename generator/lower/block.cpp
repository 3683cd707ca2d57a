// SPDX-License-Identifier: BSD-3-Clause
#include "generator/lower/block.hpp"

#include <optional>

#include "generator/program/fold.hpp"
#include "runtime/base/error.hpp"

namespace kanec::lower {
namespace {

struct Cyclic {
  int i, j, k;
};
constexpr Cyclic cyclic[] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}};

Block identity_times(Builder& builder, Ref value) {
  const Ref zero = builder.constant(0.0);
  return {3, 3, {value, zero, zero, zero, value, zero, zero, zero, value}};
}

}  // namespace

Block scalar(Ref value) { return {1, 1, {value}}; }

Block vector(Ref a, Ref b, Ref c) { return {3, 1, {a, b, c}}; }

Block operator-(const Block& a) {
  Block result = a;
  for (Ref& entry : result.entries) entry = -entry;
  return result;
}

Block transposed(const Block& a) {
  Block result{a.columns, a.rows, {}};
  for (int i = 0; i < a.rows; ++i)
    for (int j = 0; j < a.columns; ++j) result.at(j, i) = a.at(i, j);
  return result;
}

Block add(Builder& builder, const Block& a, const Block& b) {
  if (a.is_scalar() && b.size() == 9) return add(builder, identity_times(builder, a.at(0)), b);
  if (b.is_scalar() && a.size() == 9) return add(builder, a, identity_times(builder, b.at(0)));
  if (a.rows != b.rows || a.columns != b.columns) throw InternalError("sum of blocks of different shape");
  Block result = a;
  for (int i = 0; i < a.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    result.entries[at] = builder.add(a.entries[at], b.entries[at]);
  }
  return result;
}

Block multiply(Builder& builder, const Block& a, const Block& b) {
  if (a.is_scalar() || b.is_scalar()) {
    const Block& factor = a.is_scalar() ? a : b;
    Block result = a.is_scalar() ? b : a;
    for (int i = 0; i < result.size(); ++i) {
      Ref& entry = result.entries[static_cast<std::size_t>(i)];
      entry = builder.multiply(factor.at(0), entry);
    }
    return result;
  }
  if (a.columns != b.rows) throw InternalError("product of blocks whose shapes do not fit");
  Block result{a.rows, b.columns, {}};
  for (int i = 0; i < a.rows; ++i)
    for (int j = 0; j < b.columns; ++j) {
      Ref entry = builder.multiply(a.at(i, 0), b.at(0, j));
      for (int k = 1; k < a.columns; ++k) entry = builder.add(entry, builder.multiply(a.at(i, k), b.at(k, j)));
      result.at(i, j) = entry;
    }
  return result;
}

Block skew(Builder& builder, const Block& a) {
  const Ref zero = builder.constant(0.0);
  return {3, 3, {zero, -a.at(2), a.at(1), a.at(2), zero, -a.at(0), -a.at(1), a.at(0), zero}};
}

Ref dot(Builder& builder, const Block& a, const Block& b) { return multiply(builder, transposed(a), b).at(0); }

namespace {

// Whether a vector is a coordinate axis or its opposite.
bool is_along(const Builder& builder, const Block& axis, const Cyclic& at) {
  using program::fold::is;
  const bool is_unit = is(builder, axis.at(at.i), 1) || is(builder, axis.at(at.i), -1);
  return is_unit && is(builder, axis.at(at.j), 0) && is(builder, axis.at(at.k), 0);
}

}  // namespace

Block turn(Builder& builder, const Block& axis, Ref angle) {
  for (const Cyclic& at : cyclic) {
    if (!is_along(builder, axis, at)) continue;
    const bool is_opposite = program::fold::is(builder, axis.at(at.i), -1);
    const Ref cosine = builder.cosine(angle), sine = builder.sine(is_opposite ? -angle : angle);
    const Ref zero = builder.constant(0.0);
    Block result{3, 3, {}};
    result.entries.fill(zero);
    result.at(at.i, at.i) = builder.constant(1.0);
    result.at(at.j, at.j) = result.at(at.k, at.k) = cosine;
    result.at(at.k, at.j) = sine;
    result.at(at.j, at.k) = -sine;
    return result;
  }
  const Ref sine = builder.sine(angle), cosine = builder.cosine(angle);
  const Block cross = skew(builder, axis);
  const Block square = multiply(builder, cross, cross);
  // 1 + (1 - cos) ã ã = (1 + ã ã) - cos ã ã: for a coordinate axis every entry is 0, 1 or the cosine
  const Block fixed = add(builder, scalar(builder.constant(1.0)), square);
  return add(builder, add(builder, multiply(builder, scalar(sine), cross), multiply(builder, scalar(-cosine), square)),
             fixed);
}

namespace {

// C = [1, 0, 0; 0, c, -s; 0, s, c] or the same about another axis.
struct Plane {
  Cyclic at;
  Ref c, s;
};

std::optional<Plane> plane_of(const Builder& builder, const Block& C) {
  using program::fold::is;
  for (const Cyclic& at : cyclic) {
    const auto [i, j, k] = at;
    const bool fixes = is(builder, C.at(i, i), 1) && is(builder, C.at(i, j), 0) && is(builder, C.at(i, k), 0) &&
                       is(builder, C.at(j, i), 0) && is(builder, C.at(k, i), 0);
    if (fixes && C.at(j, j) == C.at(k, k) && C.at(j, k) == -C.at(k, j)) return Plane{at, C.at(j, j), C.at(k, j)};
  }
  return std::nullopt;
}

// Rows j and k of C A in a plane rotation, of one column.
void turn_pair(Builder& builder, const Plane& plane, Ref& a, Ref& b) {
  const auto times = [&](Ref u, Ref v) { return builder.multiply(u, v); };
  const Ref turned = builder.subtract(times(plane.c, a), times(plane.s, b));
  b = builder.add(times(plane.s, a), times(plane.c, b));
  a = turned;
}

// [a, f; g, b] by the double angle: with w = s (a − b) + c (f + g) it is [a − s w, c w − g; c w − f, b + s w].
void turn_block(Builder& builder, const Plane& plane, Block& A, bool is_symmetric) {
  const auto [i, j, k] = plane.at;
  const Ref a = A.at(j, j), b = A.at(k, k), f = A.at(j, k), g = A.at(k, j);
  const auto times = [&](Ref u, Ref v) { return builder.multiply(u, v); };
  const Ref twice = is_symmetric ? times(times(builder.constant(2.0), plane.c), f) : times(plane.c, builder.add(f, g));
  const Ref w = builder.add(times(plane.s, builder.subtract(a, b)), twice);
  const Ref sw = times(plane.s, w), cw = times(plane.c, w);
  A.at(j, j) = builder.subtract(a, sw);
  A.at(k, k) = builder.add(b, sw);
  A.at(j, k) = builder.subtract(cw, g);
  A.at(k, j) = is_symmetric ? A.at(j, k) : builder.subtract(cw, f);
}

Block plane_congruence(Builder& builder, const Plane& plane, Block A, bool is_symmetric) {
  const auto [i, j, k] = plane.at;
  turn_block(builder, plane, A, is_symmetric);
  turn_pair(builder, plane, A.at(j, i), A.at(k, i));
  if (!is_symmetric) turn_pair(builder, plane, A.at(i, j), A.at(i, k));
  if (is_symmetric) A.at(i, j) = A.at(j, i), A.at(i, k) = A.at(k, i);
  return A;
}

}  // namespace

Block congruence(Builder& builder, const Block& C, const Block& J) {
  if (const auto plane = plane_of(builder, C)) return plane_congruence(builder, *plane, J, true);
  const Block left = multiply(builder, C, J);
  Block result{3, 3, {}};
  for (int i = 0; i < 2; ++i)
    for (int j = i; j < 3; ++j) {
      Ref entry = builder.multiply(left.at(i, 0), C.at(j, 0));
      for (int k = 1; k < 3; ++k) entry = builder.add(entry, builder.multiply(left.at(i, k), C.at(j, k)));
      result.at(i, j) = result.at(j, i) = entry;
    }
  const Ref trace = builder.add(builder.add(J.at(0, 0), J.at(1, 1)), J.at(2, 2));
  result.at(2, 2) = builder.subtract(builder.subtract(trace, result.at(0, 0)), result.at(1, 1));
  return result;
}

Block similarity(Builder& builder, const Block& C, const Block& A) {
  if (const auto plane = plane_of(builder, C)) return plane_congruence(builder, *plane, A, false);
  return multiply(builder, multiply(builder, C, A), transposed(C));
}

Block rotation(Builder& builder, const Block& e, Ref eps4) {
  const Block twice = multiply(builder, scalar(builder.constant(2.0)), e);
  const auto product = [&](int i, Ref other) { return builder.multiply(twice.at(i), other); };
  const Ref xx = product(0, e.at(0)), yy = product(1, e.at(1)), zz = product(2, e.at(2));
  const Ref xy = product(0, e.at(1)), xz = product(0, e.at(2)), yz = product(1, e.at(2));
  const Ref wx = product(0, eps4), wy = product(1, eps4), wz = product(2, eps4);
  const auto one_less = [&](Ref a, Ref b) { return builder.subtract(builder.subtract(builder.constant(1.0), a), b); };
  const auto sum = [&](Ref a, Ref b) { return builder.add(a, b); };
  return {3,
          3,
          {one_less(yy, zz), sum(xy, -wz), sum(xz, wy),  //
           sum(xy, wz), one_less(xx, zz), sum(yz, -wx),  //
           sum(xz, -wy), sum(yz, wx), one_less(xx, yy)}};
}

Block ldl(Builder& builder, const Block& symmetric) {
  const Block& J = symmetric;
  const auto times = [&](Ref a, Ref b) { return builder.multiply(a, b); };
  const auto less = [&](Ref a, Ref b) { return builder.subtract(a, b); };
  const auto inverse_of = [&](Ref a) { return builder.divide(builder.constant(1.0), a); };
  Block result{3, 3, {}};
  result.entries.fill(builder.constant(0.0));
  result.at(0, 0) = inverse_of(J.at(0, 0));
  result.at(1, 0) = times(result.at(0, 0), J.at(0, 1));
  result.at(2, 0) = times(result.at(0, 0), J.at(0, 2));
  result.at(1, 1) = inverse_of(less(J.at(1, 1), times(result.at(1, 0), J.at(0, 1))));
  const Ref coupling = less(J.at(1, 2), times(result.at(1, 0), J.at(0, 2)));
  result.at(2, 1) = times(result.at(1, 1), coupling);
  const Ref last = less(less(J.at(2, 2), times(result.at(2, 0), J.at(0, 2))), times(result.at(2, 1), coupling));
  result.at(2, 2) = inverse_of(last);
  return result;
}

Block forward(Builder& builder, const Block& factors, Block B) {
  for (int i = 1; i < 3; ++i)
    for (int j = 0; j < i; ++j)
      for (int c = 0; c < B.columns; ++c)
        B.at(i, c) = builder.subtract(B.at(i, c), builder.multiply(factors.at(i, j), B.at(j, c)));
  return B;
}

Block scaled(Builder& builder, const Block& factors, Block B) {
  for (int i = 0; i < 3; ++i)
    for (int c = 0; c < B.columns; ++c) B.at(i, c) = builder.multiply(factors.at(i, i), B.at(i, c));
  return B;
}

Block backward(Builder& builder, const Block& factors, Block B) {
  for (int i = 1; i >= 0; --i)
    for (int j = i + 1; j < 3; ++j)
      for (int c = 0; c < B.columns; ++c)
        B.at(i, c) = builder.subtract(B.at(i, c), builder.multiply(factors.at(j, i), B.at(j, c)));
  return B;
}

Block outer(Builder& builder, const Block& a, const Block& b) { return multiply(builder, a, transposed(b)); }

Block inverse(Builder& builder, const Block& symmetric) {
  const auto& I = symmetric;
  Block cofactor{3, 3, {}};
  for (const auto [i, j, k] : cyclic) {
    const auto minor = [&](Ref a, Ref b, Ref c, Ref d) {
      return builder.subtract(builder.multiply(a, b), builder.multiply(c, d));
    };
    cofactor.at(i, i) = minor(I.at(j, j), I.at(k, k), I.at(j, k), I.at(j, k));
    cofactor.at(j, k) = cofactor.at(k, j) = minor(I.at(i, j), I.at(i, k), I.at(j, k), I.at(i, i));
  }
  Ref determinant = builder.multiply(I.at(0, 0), cofactor.at(0, 0));
  for (int j = 1; j < 3; ++j) determinant = builder.add(determinant, builder.multiply(I.at(0, j), cofactor.at(0, j)));
  return multiply(builder, scalar(builder.divide(builder.constant(1.0), determinant)), cofactor);
}

Block gyroscopic(Builder& builder, const Block& inertia, const Block& omega) {
  const auto times = [&](Ref a, Ref b) { return builder.multiply(a, b); };
  const auto less = [&](Ref a, Ref b) { return builder.subtract(a, b); };
  const auto& I = inertia;
  const auto& w = omega;
  Block result{3, 1, {}};
  for (const auto [i, j, k] : cyclic) {
    const Ref squares = less(times(w.at(j), w.at(j)), times(w.at(k), w.at(k)));
    Ref sum = times(less(I.at(k, k), I.at(j, j)), times(w.at(j), w.at(k)));
    sum = builder.add(sum, times(I.at(j, k), squares));
    sum = builder.add(sum, times(I.at(i, k), times(w.at(i), w.at(j))));
    result.at(i) = less(sum, times(I.at(i, j), times(w.at(i), w.at(k))));
  }
  return result;
}

Block second_moment(Builder& builder, const Block& inertia) {
  const Ref half = builder.constant(0.5);
  Block result = -inertia;
  for (const auto [i, j, k] : cyclic) {
    const Ref others = builder.add(inertia.at(j, j), inertia.at(k, k));
    result.at(i, i) = builder.multiply(half, builder.subtract(others, inertia.at(i, i)));
  }
  return result;
}

Block inertia_moment(Builder& builder, const Block& spin, const Block& inertia) {
  const auto times = [&](Ref a, Ref b) { return builder.multiply(a, b); };
  const auto less = [&](Ref a, Ref b) { return builder.subtract(a, b); };
  const Block J = second_moment(builder, inertia);
  const auto& U = spin;
  Block result{3, 1, {}};
  for (const auto [i, j, k] : cyclic) {
    Ref sum = less(times(J.at(j, j), U.at(k, j)), times(J.at(k, k), U.at(j, k)));
    sum = builder.add(sum, times(J.at(j, k), less(U.at(k, k), U.at(j, j))));
    sum = builder.add(sum, times(J.at(i, j), U.at(k, i)));
    result.at(i) = less(sum, times(J.at(i, k), U.at(j, i)));
  }
  return result;
}

}  // namespace kanec::lower
