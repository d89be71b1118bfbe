#include "core/io/journal_file.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/io/byte_writer.h"
#include "core/io/io.h"
#include "core/io/source.h"

namespace aomd::io {
namespace {

constexpr std::string_view magic = "AOMDJRNL";
constexpr std::uint32_t version = 1;
constexpr std::size_t checksum_at = 80, header_size = 88, step_size = 16, word_size = 4;
constexpr std::size_t piece_size = 1 << 16;  // of what is written at a time

enum JournalFlag : std::uint32_t {
  has_feature_angle = 1,
  nonmanifold_edges = 2,
  keep_present = 4,
  seams_kept = 8,
  all_flags = 15
};

/// FNV-1a over 64-bit values, with a last mix so that every bit counts.
class Hash {
 public:
  void add(std::uint64_t value) { state_ = (state_ ^ value) * 0x100000001b3u ^ state_ >> 47; }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  [[nodiscard]] std::uint64_t value() const { return state_ ^ state_ >> 29; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

template <typename Value>
Value load(std::string_view bytes, std::size_t at) {
  char raw[sizeof(Value)];
  for (std::size_t i = 0; i < sizeof raw; ++i)
    raw[i] = bytes[at + (std::endian::native == std::endian::little ? i : sizeof raw - 1 - i)];
  Value value;
  std::memcpy(&value, raw, sizeof raw);
  return value;
}

/// Over the words of a file but the checksum itself, in pieces of whole words.
class Checksum {
 public:
  void add(std::string_view bytes) {
    for (std::size_t at = 0; at + word_size <= bytes.size();
         at += word_size, position_ += word_size)
      if (position_ != checksum_at && position_ != checksum_at + word_size)
        hash_.add(std::uint64_t{load<std::uint32_t>(bytes, at)});
  }
  [[nodiscard]] std::uint64_t value() const { return hash_.value(); }

 private:
  Hash hash_;
  std::size_t position_ = 0;
};

std::uint64_t checksum(std::string_view bytes) {
  Checksum sum;
  sum.add(bytes);
  return sum.value();
}

std::uint32_t flags_of(const JournalFile& file) {
  const ClassifyOptions& options = file.classify;
  return (file.seams ? seams_kept : 0u) | (options.feature_angle_deg ? has_feature_angle : 0u) |
         (options.nonmanifold_edges ? nonmanifold_edges : 0u) |
         (options.keep_present ? keep_present : 0u);
}

void put_header(detail::ByteWriter& out, const JournalFile& file, std::uint64_t sum) {
  const auto put = [&](auto value) { out.raw<std::endian::little>(value); };
  out << magic;
  put(version);
  put(flags_of(file));
  for (const std::uint32_t n : file.start.counts) put(n);
  put(std::uint64_t{0});
  put(file.start.hash);
  put(file.classify.feature_angle_deg.value_or(0.0));
  put(file.classify.corner_angle_deg);
  put(std::uint64_t{file.journal.steps().size()});
  put(std::uint64_t{file.journal.words().size()});
  put(sum);
}

void put_step(detail::ByteWriter& out, const JournalStep& step) {
  const std::uint32_t kind = static_cast<std::uint32_t>(step.kind);
  out.raw<std::endian::little>(kind | std::uint32_t{step.entity.dimension} << 8);
  out.raw<std::endian::little>(step.entity.index);
  out.raw<std::endian::little>(step.begin);
}

void put_pieces(const JournalFile& file, std::uint64_t sum, const OutputFiles::Take& take) {
  detail::ByteWriter out;
  const auto hand_over = [&](std::size_t from) {
    if (out.size() >= from) take(out.take());
  };
  put_header(out, file, sum);
  for (const JournalStep& step : file.journal.steps()) {
    put_step(out, step);
    hand_over(piece_size);
  }
  for (const std::uint32_t word : file.journal.words()) {
    out.raw<std::endian::little>(word);
    hand_over(piece_size);
  }
  hand_over(1);
}

JournalFile parse_header(const detail::Source& source) {
  const std::string_view bytes = source.bytes;
  if (bytes.substr(0, magic.size()) != magic) source.fail("is no journal");
  if (bytes.size() < header_size)
    source.fail_at_byte(bytes.size(), "the journal ends within its header");
  if (const auto found = load<std::uint32_t>(bytes, 8); found != version)
    source.fail_at_byte(8, "a journal of version " + std::to_string(found) +
                               "; this program reads version " + std::to_string(version));
  const auto flags = load<std::uint32_t>(bytes, 12);
  JournalFile file;
  for (std::size_t dim = 0; dim < 4; ++dim)
    file.start.counts[dim] = load<std::uint32_t>(bytes, 16 + 4 * dim);
  file.start.hash = load<std::uint64_t>(bytes, 40);
  const auto feature = load<double>(bytes, 48), corner = load<double>(bytes, 56);
  const auto is_angle = [](double angle) { return angle >= 0 && angle <= 180; };
  if (flags > all_flags || !is_angle(feature) || !is_angle(corner))
    source.fail_at_byte(12, "the journal's header is damaged");
  file.classify.feature_angle_deg =
      flags & has_feature_angle ? std::optional(feature) : std::nullopt;
  file.classify.corner_angle_deg = corner;
  file.classify.nonmanifold_edges = (flags & nonmanifold_edges) != 0;
  file.classify.keep_present = (flags & keep_present) != 0;
  file.seams = (flags & seams_kept) != 0;
  return file;
}

std::vector<JournalStep> parse_steps(const detail::Source& source, std::size_t count) {
  std::vector<JournalStep> steps(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = header_size + i * step_size;
    const auto head = load<std::uint32_t>(source.bytes, at);
    const std::uint32_t kind = head & 255u, dim = head >> 8;
    if (kind > static_cast<std::uint32_t>(StepKind::Classify) || dim > 3)
      source.fail_at_byte(at, "a step of unknown kind");
    steps[i] = {static_cast<StepKind>(kind),
                EntityRef(static_cast<int>(dim), load<std::uint32_t>(source.bytes, at + 4)),
                load<std::uint64_t>(source.bytes, at + 8)};
  }
  return steps;
}

}  // namespace

MeshFingerprint fingerprint(const Mesh& mesh) {
  MeshFingerprint print;
  Hash hash;
  std::array<std::uint32_t, max_shape_vertices> buffer;
  for (int dim = 0; dim < 4; ++dim) {
    print.counts[static_cast<std::size_t>(dim)] = mesh.count(dim);
    for (std::uint32_t id = 0; id < mesh.capacity(dim); ++id) {
      const EntityRef e(dim, id);
      if (!mesh.alive(e)) continue;
      hash.add(std::uint64_t{id} << 32 | mesh.classification(e).bits());
      for (const std::uint32_t v : mesh.vertices_of(e, buffer)) hash.add(std::uint64_t{v});
      if (dim == 0)
        for (int axis = 0; axis < 3; ++axis) hash.add(mesh.position(Vertex(id))[axis]);
    }
  }
  print.hash = hash.value();
  return print;
}

void put_bytes(const JournalFile& file, const OutputFiles::Take& take) {
  Checksum sum;
  put_pieces(file, 0, [&](std::string_view bytes) { sum.add(bytes); });
  put_pieces(file, sum.value(), take);
}

void write_journal(const std::filesystem::path& path, const JournalFile& file) {
  OutputFiles files;
  files.add(path, [&](const OutputFiles::Take& take) { put_bytes(file, take); });
  files.commit();
}

JournalFile read_journal(const std::filesystem::path& path) {
  const detail::FileBytes content(path);
  const detail::Source source{path.string(), content.view()};
  JournalFile file = parse_header(source);
  const auto step_count = load<std::uint64_t>(source.bytes, 64),
             word_count = load<std::uint64_t>(source.bytes, 72);
  const std::uint64_t room = source.bytes.size() - header_size;
  if (step_count > room / step_size || word_count > room / word_size ||
      step_count * step_size + word_count * word_size != room)
    source.fail_at_byte(64, "the journal is truncated or has bytes to spare");
  if (load<std::uint64_t>(source.bytes, checksum_at) != checksum(source.bytes))
    source.fail_at_byte(checksum_at, "the journal is damaged: its checksum does not fit");
  std::vector<std::uint32_t> words(word_count);
  for (std::size_t i = 0; i < word_count; ++i)
    words[i] =
        load<std::uint32_t>(source.bytes, header_size + step_count * step_size + i * word_size);
  try {
    file.journal.restore(std::move(words), parse_steps(source, step_count));
  } catch (const FileError&) {
    throw;
  } catch (const std::runtime_error& e) {
    source.fail(e.what());
  }
  return file;
}

}  // namespace aomd::io
