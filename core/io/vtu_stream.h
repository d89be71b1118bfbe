#pragma once
// The encoded form of an array of a VTK XML file, base64 or raw, as bytes in sequence.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace aomd::io::detail {

/// Where an encoded form lies in a file, at the most.
struct VtuPlace {
  std::uint64_t begin = 0, end = 0;
  bool base64 = false;
};

/// The bytes that it stands for, decoded as far as they are asked for: 64 KiB at a time.
class VtuStream {
 public:
  VtuStream(std::string name, const VtuPlace& place)
      : name_(std::move(name)), at_(place.begin), end_(place.end), base64_(place.base64) {}
  VtuStream(const VtuStream&) = delete;
  VtuStream& operator=(const VtuStream&) = delete;
  virtual ~VtuStream() = default;

  /// Throws ReadError with the byte of the file up to which it has been decoded.
  [[noreturn]] void fail(const std::string& what) const;
  /// That byte.
  [[nodiscard]] std::uint64_t at() const { return at_ + used_; }
  /// No more bytes than this are left.
  [[nodiscard]] std::uint64_t left() const;

  /// The next ones, `most` or fewer but not none, as long as nothing else is asked for. Throws
  /// ReadError at the end, and where something is no base64.
  [[nodiscard]] std::string_view some(std::uint64_t most);
  /// The next n in place of what `into` holds.
  void take(std::size_t n, std::string& into);

 private:
  /// What follows what it has returned before: at least one byte, at most `most`.
  virtual std::string_view more_of_file(std::uint64_t most) = 0;

  void need_encoded();
  [[nodiscard]] std::string_view decoded(std::size_t n);
  std::size_t decode_group(char* to);

  std::string name_;
  std::uint64_t at_, end_;    ///< of the file: where `encoded_` begins, and where all ends
  std::string_view encoded_;  ///< what has been read last
  std::size_t used_ = 0;      ///< of that
  bool base64_;
  std::string decoded_, rest_;  ///< the rest has not been asked for
};

}  // namespace aomd::io::detail
