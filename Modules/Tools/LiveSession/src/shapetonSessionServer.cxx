#include "shapetonSessionServer.h"

#include "shapetonExceptions.h"
#include "shapetonHtmlReport.h"
#include "shapetonLiveSession.h"
#include "shapetonScriptPage.h"
#include "shapetonSessionCommands.h"
#include "shapetonSessionFrames.h"

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <atomic>
#include <chrono>
#include <csignal>
#include <deque>
#include <set>

namespace shapeton
{
extern const char * const SessionScript[];
extern const char * const SessionStyle[];

namespace
{
namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Tcp = asio::ip::tcp;
using Clock = std::chrono::steady_clock;
using Message = std::shared_ptr<const std::string>;

constexpr std::size_t greatestHeader = 8192;      // bytes of an HTTP request
constexpr std::size_t greatestMessage = 1U << 18; // bytes; a stroke of 4096 balls has less
constexpr std::size_t mostConnections = 64;       // chosen; more are refused
/** How long the server waits for messages when it is idle, and how often it reads them during long work. */
constexpr std::chrono::milliseconds idleWait{ 20 };
constexpr std::chrono::milliseconds busyWait{ 10 };

std::chrono::milliseconds
Milliseconds(double seconds)
{
  constexpr double perSecond = 1000.0;
  return std::chrono::milliseconds(static_cast<std::int64_t>(perSecond * seconds));
}

/** 128 random bits. */
std::string
NewToken()
{
  constexpr std::size_t length = 32;
  const char * const    digits = "0123456789abcdef";
  std::random_device    random; // of the operating system
  std::string           token;
  while (token.size() < length)
  {
    token += digits[random() % 16];
  }
  return token;
}

/** Takes the same time for each wrong text of the same length. */
bool
IsSameSecret(std::string_view given, std::string_view secret)
{
  unsigned char difference = given.size() == secret.size() ? 0 : 1;
  for (std::size_t i = 0; i < secret.size(); ++i)
  {
    difference |= static_cast<unsigned char>((i < given.size() ? given[i] : '\0') ^ secret[i]);
  }
  return difference == 0;
}

/** The host of "host:port", also of "[::1]:port". */
std::string_view
HostOf(std::string_view hostAndPort)
{
  const auto colon = hostAndPort.rfind(':');
  const bool hasPort = colon != std::string_view::npos && hostAndPort.find(']', colon) == std::string_view::npos &&
                       hostAndPort.find_first_not_of("0123456789", colon + 1) == std::string_view::npos;
  return hasPort ? hostAndPort.substr(0, colon) : hostAndPort;
}

std::string_view
TextOf(beast::string_view text)
{
  return { text.data(), text.size() };
}
} // namespace

struct SessionServer::Impl
{
  struct Connection;
  using Request = http::request<http::empty_body>;
  using Reply = http::response<http::string_body>;

  Impl(LiveSession & given, const SessionServerSettings & wanted)
    : session(given), settings(wanted), acceptor(context), signals(context)
  {
    boost::system::error_code error;
    const auto                address = asio::ip::make_address(settings.address, error);
    RequireParameter(!error && !address.is_unspecified(),
                     "the parameter \"address\" = " + settings.address + " is not the IP address of an interface");
    const Tcp::endpoint endpoint(address, settings.port);
    acceptor.open(endpoint.protocol());
    acceptor.set_option(asio::socket_base::reuse_address(true));
    acceptor.bind(endpoint, error);
    RequireParameter(!error,
                     "the parameter \"port\" = " + std::to_string(settings.port) + " at " + settings.address +
                       " cannot be used: " + error.message() + "; use another port, or 0 for a free one");
    acceptor.listen();
    for (const int signal : { SIGINT, SIGTERM, SIGHUP })
    {
      signals.add(signal);
    }
    signals.async_wait([this](boost::system::error_code failure, int) { isStopped = isStopped || !failure; });
    Accept();
  }

  std::string
  HostOfUrl() const
  {
    const auto address = acceptor.local_endpoint().address();
    return (address.is_v6() ? "[" + address.to_string() + "]" : address.to_string()) + ":" +
           std::to_string(acceptor.local_endpoint().port());
  }

  void
  Accept();

  // ---- checks of a request ----
  /** Any other name may be that of a foreign site made to resolve to this machine. The port may be that of an SSH
   * tunnel. */
  bool
  IsOurHost(std::string_view host) const
  {
    const std::string_view name = HostOf(host);
    return name == "localhost" || name == "127.0.0.1" || name == "[::1]" || name == HostOf(HostOfUrl());
  }

  /** The status with which a request is rejected; http::status::ok if it is not. */
  http::status
  Check(const Request & request) const
  {
    const std::string_view host = TextOf(request[http::field::host]);
    const std::string_view origin = TextOf(request[http::field::origin]);
    const std::string_view target = TextOf(request.target());
    const bool             isUpgrade = websocket::is_upgrade(request);
    if (!IsOurHost(host))
    {
      return http::status::misdirected_request;
    }
    if (request.method() != http::verb::get)
    {
      return http::status::method_not_allowed;
    }
    if ((isUpgrade || !origin.empty()) && origin != "http://" + std::string(host))
    {
      return http::status::forbidden;
    }
    const std::size_t end = target.find('/', 1);
    if (!IsSameSecret(target.substr(0, end), "/" + token))
    {
      return http::status::forbidden;
    }
    const std::string_view rest = end == std::string_view::npos ? "" : target.substr(end);
    return rest == (isUpgrade ? "/live" : "/") ? http::status::ok : http::status::not_found;
  }

  Reply
  ReplyTo(const Request & request) const
  {
    const http::status status = Check(request);
    Reply              reply(status, request.version());
    reply.set(http::field::content_type, status == http::status::ok ? "text/html; charset=utf-8" : "text/plain");
    reply.set(http::field::cache_control, "no-store");
    reply.set("Referrer-Policy", "no-referrer"); // the URL contains the token
    reply.set("X-Content-Type-Options", "nosniff");
    reply.set("X-Frame-Options", "DENY");
    reply.set("Cross-Origin-Resource-Policy", "same-origin");
    reply.body() = status == http::status::ok ? Page(std::string(TextOf(request[http::field::host])))
                                              : std::string(TextOf(http::obsolete_reason(status))) + "\n";
    reply.keep_alive(false);
    reply.prepare_payload();
    return reply;
  }

  /** `host` has been checked. */
  std::string
  Page(const std::string & host) const
  {
    ScriptPage page{ "Shapeton session",
                     PageText(SessionStyle),
                     PageText(SessionScript),
                     "startSession(" + ScriptText(session.GetInfo()) + ");" };
    page.connections = "ws://" + host;
    return shapeton::TextOf(page, PageBlocks("", true, nullptr));
  }

  // ---- work ----
  void
  Run()
  {
    lastPage = Clock::now();
    while (!isStopped)
    {
      Execute();
      Serve();
      if (session.Work([this] { Look(); }))
      {
        context.poll();
      }
      else if (!HasNews())
      {
        context.run_one_for(idleWait);
      }
      context.poll();
      isStopped = isStopped || IsAbandoned();
    }
    Close();
  }

  /** Reads messages during long work. */
  void
  Look()
  {
    if (isLooking || Clock::now() - lastLook < busyWait)
    {
      return;
    }
    isLooking = true; // Serve() is work, too
    context.poll();
    if (session.IsComputingHeat())
    {
      Serve();
    }
    isLooking = false;
    lastLook = Clock::now();
    if (isStopped || !commands.empty())
    {
      session.Interrupt();
    }
  }

  bool
  IsAbandoned()
  {
    if (!pages.empty() || !hadPage)
    {
      lastPage = Clock::now();
    }
    return Clock::now() - lastPage > Milliseconds(isPageLost ? settings.secondsAfterLoss : settings.secondsAfterClose);
  }

  bool
  HasNews() const;
  void
  Serve();
  void
  Execute();
  void
  Close();

  LiveSession &                         session;
  const SessionServerSettings           settings;
  asio::io_context                      context;
  Tcp::acceptor                         acceptor;
  asio::signal_set                      signals;
  const std::string                     token{ NewToken() };
  std::atomic<bool>                     isStopped{ false };
  bool                                  isLooking{ false };
  bool                                  hadPage{ false };
  bool                                  isPageLost{ false }; ///< the last page to leave was not closed
  Clock::time_point                     lastLook{};
  Clock::time_point                     lastPage{};
  std::size_t                           connections{ 0 };
  std::set<std::shared_ptr<Connection>> pages; ///< with an open WebSocket
  /** Commands, each with its page; a page's next message is read after its command has been executed. */
  std::deque<std::pair<std::shared_ptr<Connection>, Json>> commands;
};

/** One connection: an HTTP request, which may become a WebSocket. */
struct SessionServer::Impl::Connection : std::enable_shared_from_this<Connection>
{
  Connection(Impl & owner, Tcp::socket && socket) : server(owner), stream(std::move(socket)) { ++server.connections; }
  ~Connection() { --server.connections; }

  void
  Start()
  {
    parser.emplace();
    parser->header_limit(greatestHeader);
    stream.next_layer().expires_after(Milliseconds(server.settings.secondsOfSilence));
    http::async_read(stream.next_layer(), buffer, *parser, [self = shared_from_this()](beast::error_code error, auto) {
      if (!error)
      {
        self->Answer();
      }
    });
  }

  void
  Answer()
  {
    const Request & request = parser->get();
    if (websocket::is_upgrade(request) && server.Check(request) == http::status::ok)
    {
      Upgrade();
      return;
    }
    reply = server.ReplyTo(request);
    http::async_write(stream.next_layer(), reply, [self = shared_from_this()](beast::error_code, auto) {
      beast::error_code ignored;
      self->stream.next_layer().socket().shutdown(Tcp::socket::shutdown_send, ignored);
    });
  }

  void
  Upgrade()
  {
    websocket::stream_base::timeout timeout{};
    timeout.handshake_timeout = Milliseconds(server.settings.secondsOfSilence);
    timeout.idle_timeout = Milliseconds(server.settings.secondsOfSilence);
    timeout.keep_alive_pings = true; // a dead page does not answer them
    stream.next_layer().expires_never();
    stream.set_option(timeout);
    stream.read_message_max(greatestMessage);
    stream.auto_fragment(false); // pieces of 4 KB would delay clients without a browser
    stream.async_accept(parser->get(), [self = shared_from_this()](beast::error_code error) {
      if (!error)
      {
        self->server.pages.insert(self);
        self->server.hadPage = true;
        self->Read();
      }
    });
  }

  void
  Read()
  {
    buffer.clear();
    stream.async_read(buffer, [self = shared_from_this()](beast::error_code error, auto) {
      if (error)
      {
        // A browser may reset the connection before it has received the answer to its closing message.
        self->server.isPageLost = !self->stream.reason();
        self->Drop();
        return;
      }
      self->Take(beast::buffers_to_string(self->buffer.data()));
    });
  }

  /** Views and requests for frames require no work by the session and are answered at once. */
  void
  Take(const std::string & text)
  {
    const Json command = Json::parse(text, nullptr, false);
    const Json name = command.is_object() ? command.value("do", Json()) : Json();
    if (name == "ready")
    {
      isReady = true;
    }
    else if (name != "view")
    {
      server.commands.emplace_back(shared_from_this(), command);
      return;
    }
    else
    {
      Answer(command, [&] { return SetView(command); });
    }
    Read();
  }

  Json
  SetView(const Json & command)
  {
    RequireKeys(command, { "place", "whole" });
    if (command.contains("whole"))
    {
      viewer = SessionViewer();
      viewer.isWhole = FlagOf(command, "whole");
    }
    if (command.contains("place") || !command.contains("whole"))
    {
      const auto place = PointOf(command, "place");
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        viewer.place[axis] = static_cast<std::size_t>(std::max(0.0, place[axis]));
      }
    }
    viewer.isPlaceNew = true;
    return { { "done", "view" } };
  }

  /** Sends the answer of a function, or its error. */
  template <typename TFunction>
  void
  Answer(const Json & command, const TFunction & function)
  {
    Json answer = { { "kind", "answer" } };
    try
    {
      answer.update(function());
    }
    catch (const std::exception & error)
    {
      answer = { { "kind", "error" }, { "text", error.what() } };
    }
    if (command.is_object() && command.contains("id") && command["id"].is_number())
    {
      answer["id"] = command["id"];
    }
    Send(std::make_shared<std::string>(TextOfJson(answer)), false);
  }

  void
  Execute(const Json & command)
  {
    Answer(command, [&]() -> Json {
      RequireParameter(!command.is_discarded(), "the message is not JSON");
      if (command.is_object() && command.value("do", Json()) == "picture")
      {
        Json request = command;
        request.erase("do");
        request.erase("id");
        Send(std::make_shared<std::string>(server.session.Draw(request)), true);
        return { { "done", "picture" } };
      }
      return server.session.Do(command);
    });
    Read();
  }

  void
  Send(Message message, bool isBinary)
  {
    waiting.emplace_back(std::move(message), isBinary);
    if (waiting.size() == 1)
    {
      Write();
    }
  }

  void
  Write()
  {
    stream.binary(waiting.front().second);
    stream.async_write(asio::buffer(*waiting.front().first),
                       [self = shared_from_this()](beast::error_code error, auto) {
                         if (error) // Read() ends, too, and knows whether the page has been closed
                         {
                           return;
                         }
                         self->waiting.pop_front();
                         if (!self->waiting.empty())
                         {
                           self->Write();
                         }
                       });
  }

  void
  Serve()
  {
    if (isReady && server.session.IsNewFor(viewer))
    {
      isReady = false;
      Send(std::make_shared<std::string>(server.session.Update(viewer)), true);
    }
  }

  void
  Drop()
  {
    server.pages.erase(shared_from_this());
    beast::error_code ignored;
    stream.next_layer().socket().close(ignored);
  }

  Impl &                                                server;
  websocket::stream<beast::tcp_stream>                  stream;
  beast::flat_buffer                                    buffer{ greatestMessage + greatestHeader };
  std::optional<http::request_parser<http::empty_body>> parser;
  Reply                                                 reply;
  SessionViewer                                         viewer;
  bool                                                  isReady{ false };
  std::deque<std::pair<Message, bool>>                  waiting; ///< messages to send; true for binary ones
};

void
SessionServer::Impl::Accept()
{
  acceptor.async_accept([this](beast::error_code error, Tcp::socket socket) {
    if (!error && connections < mostConnections)
    {
      socket.set_option(Tcp::no_delay(true), error);
      std::make_shared<Connection>(*this, std::move(socket))->Start();
    }
    if (acceptor.is_open())
    {
      Accept();
    }
  });
}

bool
SessionServer::Impl::HasNews() const
{
  return !commands.empty() || std::any_of(pages.begin(), pages.end(), [this](const auto & page) {
    return page->isReady && session.IsNewFor(page->viewer);
  });
}

void
SessionServer::Impl::Serve()
{
  const auto open = pages; // a page may be dropped meanwhile
  for (const auto & page : open)
  {
    page->Serve();
  }
}

void
SessionServer::Impl::Execute()
{
  while (!commands.empty() && !isStopped)
  {
    const auto [page, command] = std::move(commands.front());
    commands.pop_front();
    page->Execute(command);
  }
}

void
SessionServer::Impl::Close()
{
  boost::system::error_code ignored;
  acceptor.close(ignored);
  signals.cancel(ignored);
  commands.clear();
  const auto open = pages;
  for (const auto & page : open)
  {
    page->stream.async_close(websocket::close_code::going_away, [page](beast::error_code) { page->Drop(); });
  }
  context.restart();
  constexpr double patience = 1.0; // seconds for the last messages
  context.run_for(Milliseconds(patience));
}

SessionServer::SessionServer(LiveSession & session, const SessionServerSettings & settings)
  : m_Impl(std::make_unique<Impl>(session, settings))
{}

SessionServer::~SessionServer() = default;

std::string
SessionServer::GetUrl() const
{
  return "http://" + m_Impl->HostOfUrl() + "/" + m_Impl->token + "/";
}

void
SessionServer::Run()
{
  m_Impl->Run();
}

void
SessionServer::Stop()
{
  m_Impl->isStopped = true;
}
} // namespace shapeton
