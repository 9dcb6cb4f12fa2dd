// SPDX-License-Identifier: BSD-3-Clause
#include "digest.h"

#include <openssl/evp.h>

#include "run_tool.h"

namespace line_plane_segmentation {

std::string sha256(const std::vector<unsigned char>& bytes) {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest, &length, EVP_sha256(), nullptr) != 1) {
    throw BadInput("the SHA-256 cannot be computed by this system's OpenSSL");
  }
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < length; ++i) {
    text += kDigits[digest[i] >> 4U];
    text += kDigits[digest[i] & 15U];
  }
  return text;
}

}  // namespace line_plane_segmentation
