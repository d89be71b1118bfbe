#pragma once
// One tetrahedron as VTU in every packing. The encoded arrays come from Python's base64, zlib and
// struct.

#include <array>
#include <string>

namespace aomd::test {

/// points, connectivity, offsets, types.
using VtuArrays = std::array<const char*, 4>;

inline constexpr VtuArrays vtu_text{"0 0 0 1 0 0 0 1 0 0 0 1", "0 1 2 3", "4", "10"};
inline constexpr VtuArrays vtu_base64{
    "MAAAAAAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPw==",
    "EAAAAAAAAAABAAAAAgAAAAMAAAA=", "BAAAAAQAAAA=", "AQAAAAo="};
/// Big-endian, with 64-bit headers.
inline constexpr VtuArrays vtu_base64_big{
    "AAAAAAAAADAAAAAAAAAAAAAAAAA/gAAAAAAAAAAAAAAAAAAAP4AAAAAAAAAAAAAAAAAAAD+AAAA=",
    "AAAAAAAAABAAAAAAAAAAAQAAAAIAAAAD", "AAAAAAAAAAQAAAAE", "AAAAAAAAAAEK"};
/// In blocks of 32 bytes.
inline constexpr VtuArrays vtu_zlib{
    "AgAAACAAAAAQAAAAEAAAAA0AAAA=eJxjYEAGDfYMaHwADo4Bf3icY2BABg32AAFPAMA=",
    "AQAAACAAAAAQAAAAEwAAAA==eJxjYGBgYARiJiBmBmIAADgABw==",
    "AQAAACAAAAAEAAAADAAAAA==eJxjYWBgAAAAFAAF", "AQAAACAAAAABAAAACQAAAA==eJzjAgAACwAL"};
/// With 64-bit headers.
inline constexpr VtuArrays vtu_zlib_wide{
    "AgAAAAAAAAAgAAAAAAAAABAAAAAAAAAAEAAAAAAAAAANAAAAAAAAAA=="
    "eJxjYEAGDfYMaHwADo4Bf3icY2BABg32AAFPAMA=",
    "AQAAAAAAAAAgAAAAAAAAABAAAAAAAAAAEwAAAAAAAAA=eJxjYGBgYARiJiBmBmIAADgABw==",
    "AQAAAAAAAAAgAAAAAAAAAAQAAAAAAAAADAAAAAAAAAA=eJxjYWBgAAAAFAAF",
    "AQAAAAAAAAAgAAAAAAAAAAEAAAAAAAAACQAAAAAAAAA=eJzjAgAACwAL"};

inline constexpr const char* big_wide = R"(byte_order="BigEndian" header_type="UInt64")";
inline constexpr const char* zlib = R"(compressor="vtkZLibDataCompressor")";
inline constexpr const char* zlib_wide =
    R"(compressor="vtkZLibDataCompressor" header_type="UInt64")";

inline std::string vtu_array(const std::string& type, const std::string& name,
                             const std::string& format, const std::string& text) {
  return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" " + format + ">" + text +
         "</DataArray>\n";
}

/// `extra` stands in the piece, after the cells.
inline std::string vtu_piece(const VtuArrays& arrays, const std::string& format,
                             const std::string& extra = "") {
  return "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">\n<Points>" +
         vtu_array("Float32", "", format + " NumberOfComponents=\"3\"", arrays[0]) +
         "</Points>\n<Cells>\n" + vtu_array("Int32", "connectivity", format, arrays[1]) +
         vtu_array("Int32", "offsets", format, arrays[2]) +
         vtu_array("UInt8", "types", format, arrays[3]) + "</Cells>\n" + extra + "</Piece>\n";
}

inline std::string vtu_file(const std::string& pieces, const std::string& attributes = "",
                            const std::string& appended = "") {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" " + attributes +
         ">\n<UnstructuredGrid>\n" + pieces + "</UnstructuredGrid>\n" + appended + "</VTKFile>\n";
}

/// The same arrays, appended as base64 text.
inline std::string vtu_appended(const VtuArrays& arrays, const std::string& attributes) {
  std::string data, piece = "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">";
  const auto add = [&](const char* type, const char* name, std::size_t k) {
    piece +=
        vtu_array(type, name,
                  "format=\"appended\" NumberOfComponents=\"" + std::string(k == 0 ? "3" : "1") +
                      "\" offset=\"" + std::to_string(data.size()) + "\"",
                  "");
    data += arrays[k];
  };
  piece += "<Points>";
  add("Float32", "", 0);
  piece += "</Points><Cells>";
  add("Int32", "connectivity", 1);
  add("Int32", "offsets", 2);
  add("UInt8", "types", 3);
  return vtu_file(piece + "</Cells></Piece>", attributes,
                  "<AppendedData encoding=\"base64\">\n _" + data + "\n</AppendedData>\n");
}

}  // namespace aomd::test
