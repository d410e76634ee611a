#include "shapetonSha256.h"
#include "shapetonFileErrors.h"

#include <openssl/evp.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <vector>

namespace shapeton
{
namespace
{
class Hash
{
public:
  Hash() : m_Context(EVP_MD_CTX_new(), EVP_MD_CTX_free) { EVP_DigestInit_ex(m_Context.get(), EVP_sha256(), nullptr); }

  void
  Add(const void * bytes, std::size_t number)
  {
    Check(EVP_DigestUpdate(m_Context.get(), bytes, number));
  }

  std::string
  Hexadecimal()
  {
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned int  length = 0;
    Check(EVP_DigestFinal_ex(m_Context.get(), digest, &length));
    std::string text;
    for (unsigned int i = 0; i < length; ++i)
    {
      text += "0123456789abcdef"[digest[i] >> 4];
      text += "0123456789abcdef"[digest[i] & 15];
    }
    return text;
  }

private:
  static void
  Check(bool isDone)
  {
    if (!isDone)
    {
      throw std::runtime_error("OpenSSL does not provide SHA-256; check its configuration");
    }
  }

  std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX *)> m_Context;
};
} // namespace

std::string
Sha256OfFile(const std::string & path)
{
  const std::unique_ptr<FILE, int (*)(FILE *)> file(std::fopen(path.c_str(), "rbe"), std::fclose);
  if (!file)
  {
    ThrowCannotRead(path, errno);
  }
  Hash              hash;
  std::vector<char> buffer(1 << 20);
  std::size_t       number = 0;
  while ((number = std::fread(buffer.data(), 1, buffer.size(), file.get())) > 0)
  {
    hash.Add(buffer.data(), number);
  }
  if (std::ferror(file.get()))
  {
    ThrowCannotRead(path, errno);
  }
  return hash.Hexadecimal();
}

std::string
Sha256OfBytes(const std::string & bytes)
{
  Hash hash;
  hash.Add(bytes.data(), bytes.size());
  return hash.Hexadecimal();
}
} // namespace shapeton
