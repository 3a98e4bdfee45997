// Two values side by side. The sums over sources evaluate their formulas for two sources at once:
// the processor works on one while it waits for an operation on the other, which with one source
// alone took 5 % more time.
#pragma once

#include "sph/neighbours/lanes.hpp"

namespace slosh::sph {

template <class T>
struct Two {
  T first, second;
};

template <class T>
inline constexpr bool is_two = false;
template <class T>
inline constexpr bool is_two<Two<T>> = true;

template <class T>
Two<T> as_two(Two<T> a) {
  return a;
}
template <class T>
Two<T> as_two(T a) {
  return {a, a};
}
template <class A, class B, class Formula>
auto of_each(Two<A> a, Two<B> b, const Formula& formula) {
  return Two<decltype(formula(a.first, b.first))>{formula(a.first, b.first),
                                                  formula(a.second, b.second)};
}

template <class A, class B>
requires(is_two<A> || is_two<B>) auto operator+(A a, B b) {
  return of_each(as_two(a), as_two(b), [](auto p, auto q) { return p + q; });
}
template <class A, class B>
requires(is_two<A> || is_two<B>) auto operator-(A a, B b) {
  return of_each(as_two(a), as_two(b), [](auto p, auto q) { return p - q; });
}
template <class A, class B>
requires(is_two<A> || is_two<B>) auto operator*(A a, B b) {
  return of_each(as_two(a), as_two(b), [](auto p, auto q) { return p * q; });
}
template <class A, class B>
requires(is_two<A> || is_two<B>) auto operator/(A a, B b) {
  return of_each(as_two(a), as_two(b), [](auto p, auto q) { return p / q; });
}
template <class T>
Two<T> operator-(Two<T> a) {
  return {-a.first, -a.second};
}
template <class A, class B>
Two<A>& operator+=(Two<A>& a, B b) {
  return a = a + b;
}
template <class A, class B>
Two<A>& operator-=(Two<A>& a, B b) {
  return a = a - b;
}

template <class T>
Two<T> square_root(Two<T> a) {
  return {square_root(a.first), square_root(a.second)};
}
template <class T>
Two<T> inverse_square_root(Two<T> a) {
  return {inverse_square_root(a.first), inverse_square_root(a.second)};
}
template <class T>
Two<T> reciprocal(Two<T> a) {
  return {reciprocal(a.first), reciprocal(a.second)};
}
template <class T>
Two<T> at_least(double bound, Two<T> a) {
  return {at_least(bound, a.first), at_least(bound, a.second)};
}
template <class T>
Two<T> negative_part(Two<T> a) {
  return {negative_part(a.first), negative_part(a.second)};
}

// Sums take the two in their order.
template <Vector Number>
Number& operator+=(Number& sum, Two<Number> terms) {
  sum += terms.first;
  return sum += terms.second;
}
template <Vector Number>
Number& operator-=(Number& sum, Two<Number> terms) {
  sum -= terms.first;
  return sum -= terms.second;
}

}  // namespace slosh::sph
