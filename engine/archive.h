#pragma once

/// Values as bytes and back. What a struct is made of is said once, in a function `exchange(archive, value)` that
/// serves writing and reading alike, so that no field can be in the one and missing in the other. It takes the struct
/// apart by a structured binding: who adds a field and forgets it there does not compile.
///
/// The bytes are the same on every machine: numbers lie in little-endian order with fixed sizes, floating-point numbers
/// by their bits, lists behind their length. Reading trusts nothing: lengths are bounded by what is left, and whatever
/// cannot be leaves the reader spoilt, with zeros from then on.

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "engine/aabb.h"
#include "engine/bits.h"
#include "engine/rot.h"
#include "engine/vec2.h"

namespace proofreel {

/// `T` is `Plain`, or `const Plain` where it is written.
template <typename T, typename Plain>
concept Exchanged = std::same_as<std::remove_const_t<T>, Plain>;

/// The last value of an enumeration, as its specialisation's `value`: nothing beyond it is read.
template <typename Enumeration>
struct LastOf;

template <std::size_t size>
using UnsignedOfSize = std::conditional_t<
    size == 1, std::uint8_t,
    std::conditional_t<size == 2, std::uint16_t, std::conditional_t<size == 4, std::uint32_t, std::uint64_t>>>;

template <typename Archive, typename T>
void exchange_value(Archive& archive, T& value);

class ArchiveWriter {
 public:
  static constexpr bool reads = false;

  template <typename... Values>
  void operator()(const Values&... values) {
    (exchange_value(*this, values), ...);
  }
  template <typename Number>
  void number(Number value) {
    auto bits = bits_as<UnsignedOfSize<sizeof(Number)>>(value);
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      bytes_.push_back(static_cast<std::byte>(bits & 0xffU));
      bits = static_cast<decltype(bits)>(static_cast<std::uint64_t>(bits) >> 8U);
    }
  }
  void length(std::size_t length) { number(static_cast<std::uint64_t>(length)); }
  const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};

class ArchiveReader {
 public:
  static constexpr bool reads = true;

  /// The bytes must outlive the reader.
  explicit ArchiveReader(std::span<const std::byte> bytes) : left_(bytes) {}

  template <typename... Values>
  void operator()(Values&... values) {
    (exchange_value(*this, values), ...);
  }
  template <typename Number>
  void number(Number& value) {
    if (left_.size() < sizeof(Number)) spoil();
    UnsignedOfSize<sizeof(Number)> bits = 0;
    for (std::size_t i = 0; !spoilt_ && i < sizeof(Number); ++i) {
      const auto shifted = std::to_integer<std::uint64_t>(left_[i]) << (8 * i);
      bits = static_cast<decltype(bits)>(bits | shifted);
    }
    left_ = left_.subspan(spoilt_ ? left_.size() : sizeof(Number));
    value = bits_as<Number>(bits);
  }
  /// How many elements follow: no more than there are bytes.
  std::size_t length() {
    std::uint64_t length = 0;
    number(length);
    if (length > left_.size()) spoil();
    return spoilt_ ? 0 : static_cast<std::size_t>(length);
  }
  /// Something that cannot be has been read.
  void spoil() { spoilt_ = true; }
  bool spoilt() const { return spoilt_; }
  /// Whether all has been read, and made sense.
  bool ended_well() const { return !spoilt_ && left_.empty(); }

 private:
  std::span<const std::byte> left_;
  bool spoilt_ = false;
};

template <typename Archive, typename T>
void exchange_number(Archive& archive, T& value) {
  using Plain = std::remove_const_t<T>;
  if constexpr (std::is_same_v<Plain, bool> || std::is_enum_v<Plain>) {
    // The indirection keeps values out that the type does not have.
    using Number = std::conditional_t<std::is_same_v<Plain, bool>, std::uint8_t, UnsignedOfSize<sizeof(Plain)>>;
    auto number = static_cast<Number>(value);
    archive.number(number);
    if constexpr (Archive::reads) {
      Number last = 1;
      if constexpr (std::is_enum_v<Plain>) last = static_cast<Number>(LastOf<Plain>::value);
      if (number > last) archive.spoil();
      value = static_cast<Plain>(number > last ? 0 : number);
    }
  } else if constexpr (std::is_same_v<Plain, std::size_t>) {
    auto number = static_cast<std::uint64_t>(value);  // as wide on every machine
    archive.number(number);
    if constexpr (Archive::reads) value = static_cast<std::size_t>(number);
  } else {
    archive.number(value);
  }
}

/// Lists grow element by element, so that a false length takes no memory that the bytes do not pay for.
template <typename Archive, typename List>
void exchange_list(Archive& archive, List& list) {
  if constexpr (Archive::reads) {
    const std::size_t length = archive.length();
    list.clear();
    for (std::size_t i = 0; i < length && !archive.spoilt(); ++i) {
      typename List::value_type element{};
      exchange_value(archive, element);
      list.push_back(std::move(element));
    }
  } else {
    archive.length(list.size());
    for (const auto& element : list) exchange_value(archive, element);
  }
}

template <typename Archive, typename Optional>
void exchange_optional(Archive& archive, Optional& optional) {
  bool present = optional.has_value();
  exchange_value(archive, present);
  if constexpr (Archive::reads) {
    optional.reset();
    if (present) optional.emplace();
  }
  if (present) exchange_value(archive, *optional);
}

template <typename Archive, typename Variant, std::size_t... indices>
void exchange_variant(Archive& archive, Variant& variant, std::index_sequence<indices...> /*alternatives*/) {
  auto index = static_cast<std::uint8_t>(variant.index());
  archive.number(index);
  if constexpr (Archive::reads) {
    if (index >= sizeof...(indices)) archive.spoil();
    (void)((index == indices && (variant.template emplace<indices>(), true)) || ...);
  }
  std::visit([&archive](auto& alternative) { exchange_value(archive, alternative); }, variant);
}

template <typename T>
inline constexpr bool is_list = false;
template <typename T>
inline constexpr bool is_list<std::vector<T>> = true;
template <>
inline constexpr bool is_list<std::string> = true;
template <typename T>
inline constexpr bool is_optional = false;
template <typename T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <typename T>
inline constexpr bool is_variant = false;
template <typename... Ts>
inline constexpr bool is_variant<std::variant<Ts...>> = true;
template <typename T>
inline constexpr bool is_array = std::is_array_v<T>;
template <typename T, std::size_t size>
inline constexpr bool is_array<std::array<T, size>> = true;

template <typename Archive, typename T>
void exchange_value(Archive& archive, T& value) {
  using Plain = std::remove_const_t<T>;
  if constexpr (std::is_arithmetic_v<Plain> || std::is_enum_v<Plain>) {
    exchange_number(archive, value);
  } else if constexpr (is_list<Plain>) {
    exchange_list(archive, value);
  } else if constexpr (is_optional<Plain>) {
    exchange_optional(archive, value);
  } else if constexpr (is_array<Plain>) {
    for (auto& element : value) exchange_value(archive, element);
  } else if constexpr (is_variant<Plain>) {
    exchange_variant(archive, value, std::make_index_sequence<std::variant_size_v<Plain>>());
  } else if constexpr (requires { Plain::exchange(archive, value); }) {
    Plain::exchange(archive, value);  // classes that keep their members to themselves
  } else {
    exchange(archive, value);
  }
}

template <typename Archive, typename T>
void exchange(Archive& archive, BasicVec2<T>& v) {
  archive(v.x, v.y);
}
template <typename Archive, typename T>
void exchange(Archive& archive, const BasicVec2<T>& v) {
  archive(v.x, v.y);
}
template <typename Archive, typename T>
void exchange(Archive& archive, BasicRot<T>& q) {
  archive(q.c, q.s);
}
template <typename Archive, typename T>
void exchange(Archive& archive, const BasicRot<T>& q) {
  archive(q.c, q.s);
}
template <typename Archive, typename T>
void exchange(Archive& archive, BasicAabb<T>& box) {
  archive(box.lower, box.upper);
}
template <typename Archive, typename T>
void exchange(Archive& archive, const BasicAabb<T>& box) {
  archive(box.lower, box.upper);
}

/// Who made the bytes, and for what: 8 characters.
using Mark = std::array<char, 8>;

/// The bytes behind a mark, a version of their format and their XXH3.
std::vector<std::byte> sealed(const Mark& mark, std::uint32_t version, std::span<const std::byte> bytes);

/// The bytes within a seal; or a sentence without a subject, "was damaged", why not. `bytes` must outlive the result.
std::variant<std::span<const std::byte>, std::string> unsealed(const Mark& mark, std::uint32_t version,
                                                               std::span<const std::byte> bytes);

}  // namespace proofreel
