#ifndef shapetonSessionClient_h
#define shapetonSessionClient_h

#include "shapetonJson.h"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <cstring>
#include <string>

namespace basetest
{
/** The parts of http://host:port/token/. */
struct SessionUrl
{
  explicit SessionUrl(const std::string & url)
  {
    const auto host = url.find("//") + 2;
    const auto path = url.find('/', host);
    const auto colon = url.find(':', host);
    address = url.substr(host, colon - host);
    port = url.substr(colon + 1, path - colon - 1);
    token = url.substr(path + 1, url.size() - path - 2);
  }

  std::string
  Host() const
  {
    return address + ":" + port;
  }

  std::string address;
  std::string port;
  std::string token;
};

/** The answer to a request by HTTP. */
inline boost::beast::http::response<boost::beast::http::string_body>
Get(const SessionUrl &       url,
    const std::string &      target,
    const std::string &      host,
    const std::string &      origin = "",
    boost::beast::http::verb method = boost::beast::http::verb::get)
{
  namespace http = boost::beast::http;
  boost::asio::io_context        context;
  boost::beast::tcp_stream       stream(context);
  boost::asio::ip::tcp::resolver resolver(context);
  stream.connect(resolver.resolve(url.address, url.port));
  constexpr unsigned int          version = 11;
  http::request<http::empty_body> request(method, target, version);
  request.set(http::field::host, host);
  if (!origin.empty())
  {
    request.set(http::field::origin, origin);
  }
  http::write(stream, request);
  boost::beast::flat_buffer         buffer;
  http::response<http::string_body> response;
  http::read(stream, buffer, response);
  return response;
}

/** A page without a browser. */
class SessionClient
{
public:
  /** Throws boost::system::system_error if the WebSocket is rejected. */
  SessionClient(const SessionUrl &  url,
                const std::string & target,
                const std::string & host,
                const std::string & origin)
    : m_Stream(m_Context)
  {
    namespace websocket = boost::beast::websocket;
    boost::asio::ip::tcp::resolver resolver(m_Context);
    m_Stream.next_layer().connect(resolver.resolve(url.address, url.port));
    m_Stream.set_option(websocket::stream_base::decorator(
      [origin](websocket::request_type & request) { request.set(boost::beast::http::field::origin, origin); }));
    m_Stream.read_message_max(std::size_t{ 1 } << 28);
    m_Stream.handshake(host, target);
  }

  explicit SessionClient(const SessionUrl & url)
    : SessionClient(url, "/" + url.token + "/live", url.Host(), "http://" + url.Host())
  {}

  void
  Send(const std::string & text)
  {
    m_Stream.text(true);
    m_Stream.write(boost::asio::buffer(text));
  }

  /** The next message: an answer, or the header of a frame. Throws if the connection is closed. */
  shapeton::Json
  Read()
  {
    boost::beast::flat_buffer buffer;
    m_Stream.read(buffer);
    std::string text = boost::beast::buffers_to_string(buffer.data());
    m_Bytes = text.size();
    if (m_Stream.got_binary())
    {
      std::uint32_t length = 0;
      std::memcpy(&length, text.data(), sizeof(length));
      text = text.substr(sizeof(length), length);
    }
    return shapeton::Json::parse(text);
  }

  /** Sends a command and reads until its answer. */
  shapeton::Json
  Ask(const std::string & text)
  {
    this->Send(text);
    for (;;)
    {
      auto message = this->Read();
      if (message["kind"] != "update" && message["kind"] != "picture")
      {
        return message;
      }
    }
  }

  /** Requests and reads frames until one satisfies the condition. */
  template <typename TCondition>
  shapeton::Json
  Await(const TCondition & condition)
  {
    for (;;)
    {
      this->Send(R"({"do": "ready"})");
      const auto frame = this->Read();
      if (condition(frame))
      {
        return frame;
      }
    }
  }

  /** Closes the page; otherwise, the connection is lost. */
  void
  Close()
  {
    m_Stream.close(boost::beast::websocket::close_code::going_away);
  }

  std::size_t
  GetBytes() const
  {
    return m_Bytes;
  }

  boost::asio::ip::tcp::socket &
  GetSocket()
  {
    return m_Stream.next_layer().socket();
  }

private:
  boost::asio::io_context                                   m_Context;
  boost::beast::websocket::stream<boost::beast::tcp_stream> m_Stream;
  std::size_t                                               m_Bytes{ 0 };
};
} // namespace basetest

#endif
