// SPDX-License-Identifier: MIT
#include "stickslip/data/sha256.hpp"

#include <openssl/evp.h>

#include <array>
#include <stdexcept>

namespace stickslip::data {

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, 32> digest{};
  if (::EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, ::EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("libcrypto cannot compute a SHA-256 digest");
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : digest) {
    text += digits[byte >> 4U];
    text += digits[byte & 0xFU];
  }
  return text;
}

}  // namespace stickslip::data
