// SPDX-License-Identifier: MIT
#pragma once

/// Measurements of others, read from the files in which they were published.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace stickslip::validation {

/// Samples at increasing times, s. Lacking samples are lacking times.
struct Record {
  std::vector<double> time;
  std::vector<double> displacement;  ///< m; empty where none was measured
  std::vector<double> force;         ///< N, or in parts of the weight
};

/// The real arrays of a MAT file, version 5, by their names, column by column. Compressed variables are inflated. Throws
/// data::InputError, naming the file, for another format, a damaged element or an array that is not of doubles.
[[nodiscard]] std::map<std::string, std::vector<double>> read_mat(const std::filesystem::path& file);

/// A record of the slider on paper: `t` in s and `Fnorm`, the force of the spring in parts of the weight. Throws
/// data::InputError for what read_mat() refuses, and for arrays that lack or differ in length.
[[nodiscard]] Record read_slider_record(const std::filesystem::path& file);

/// A record of the friction damper, JSON in gzip's format: rows `data` that begin with time (s), displacement (in) and force
/// (kip), here in m and N. Throws data::InputError for another form.
[[nodiscard]] Record read_damper_record(const std::filesystem::path& file);

/// A spectrum in the text format of LabVIEW's measurements: frequencies in Hz as times, levels in dB as forces. Throws
/// data::InputError for another form.
[[nodiscard]] Record read_spectrum(const std::filesystem::path& file);

}  // namespace stickslip::validation
