"""A WebSocket client (RFC 6455) that never blocks, in Python's standard library: Slicer's Python has no other for certain,
and its event loop blocks threads."""

import base64
import hashlib
import os
import socket
import struct
import time
from urllib.parse import urlsplit


class ConnectionLost(RuntimeError):
    pass


class WebSocket:
    """Call poll() from a timer. Messages are str or bytearray."""

    greatestMessage = 1 << 32  # bytes
    greatestHeader = 8192  # bytes
    secondsOfSilence = 60.0  # the server sends a ping after half of its own limit of 30 s
    _text, _binary, _close, _ping, _pong = 1, 2, 8, 9, 10

    def __init__(self, url):
        """url: http://host:port/path"""
        place = urlsplit(url)
        self._messages = []
        self._lastByte = time.monotonic()
        self._key = base64.b64encode(os.urandom(16)).decode()
        self._out = bytearray(
            f"GET {place.path} HTTP/1.1\r\nHost: {place.netloc}\r\nOrigin: http://{place.netloc}\r\nUpgrade: websocket\r\n"
            f"Connection: Upgrade\r\nSec-WebSocket-Key: {self._key}\r\nSec-WebSocket-Version: 13\r\n\r\n".encode()
        )
        self._held = bytearray()  # messages wait until the server has accepted the connection
        self._isAccepted = False
        self._parser = self._parse()
        self._wanted = next(self._parser)
        self._socket = socket.socket(socket.AF_INET6 if ":" in place.hostname else socket.AF_INET)
        self._socket.setblocking(False)
        self._socket.connect_ex((place.hostname, place.port))  # a failure is reported by the first transfer

    def send(self, text):
        self._sendFrame(self._text, text.encode())

    def poll(self, seconds=0.02):
        """Sends and receives for at most this time; returns the complete messages. Raises ConnectionLost."""
        try:
            self._write()
            self._read(time.monotonic() + seconds)
            self._write()
        except OSError as error:
            raise ConnectionLost(f"The connection to the session was lost: {error}") from error
        if time.monotonic() - self._lastByte > self.secondsOfSilence:
            raise ConnectionLost("The connection to the session was lost: no answer")
        messages, self._messages = self._messages, []
        return messages

    def close(self):
        self._socket.close()

    def _write(self):
        while self._out:
            try:
                del self._out[: self._socket.send(self._out)]
            except BlockingIOError:
                return

    def _read(self, end):
        while time.monotonic() < end:
            try:
                count = self._socket.recv_into(self._wanted)
            except BlockingIOError:
                return
            if count == 0:
                raise ConnectionLost("The connection to the session was closed")
            self._lastByte = time.monotonic()
            self._wanted = self._wanted[count:]
            if not self._wanted:
                self._wanted = next(self._parser)

    def _sendFrame(self, opcode, payload):
        mask = os.urandom(4)
        length = len(payload)
        if length < 126:
            size = struct.pack("!B", 0x80 | length)
        elif length < 1 << 16:
            size = struct.pack("!BH", 0x80 | 126, length)
        else:
            size = struct.pack("!BQ", 0x80 | 127, length)
        masks = (mask * (length // 4 + 1))[:length]
        masked = int.from_bytes(payload, "big") ^ int.from_bytes(masks, "big")
        out = self._out if self._isAccepted else self._held
        out += struct.pack("!B", 0x80 | opcode) + size + mask + masked.to_bytes(length, "big")

    def _parse(self):
        """Yields the buffers into which the following bytes are read."""
        yield from self._parseAnswer()
        self._isAccepted = True
        self._out += self._held
        message, kind = bytearray(), None
        while True:
            head = yield from self._take(2)
            isLast, opcode, length = head[0] & 0x80, head[0] & 0x0F, head[1]
            if head[0] & 0x70 or length & 0x80:
                raise ConnectionLost("The session has sent a malformed message")
            if length >= 126:
                length = int.from_bytes((yield from self._take(2 if length == 126 else 8)), "big")
            if length + len(message) > self.greatestMessage:
                raise ConnectionLost("The session has sent a message that is too long")
            payload = yield from self._take(length)
            if opcode == self._close:
                raise ConnectionLost("The session has ended")
            if opcode == self._ping:
                self._sendFrame(self._pong, bytes(payload))
            if opcode >= self._close:
                continue
            message = message + payload if message else payload
            kind = opcode or kind
            if isLast:
                self._messages.append(message.decode() if kind == self._text else message)
                message, kind = bytearray(), None

    def _parseAnswer(self):
        text = b""
        while not text.endswith(b"\r\n\r\n"):
            text += yield from self._take(1)
            if len(text) > self.greatestHeader:
                raise ConnectionLost("The session has sent a malformed answer")
        status, *lines = text.decode("latin-1").split("\r\n")
        fields = {name.strip().lower(): value.strip() for name, _, value in (line.partition(":") for line in lines)}
        proof = hashlib.sha1((self._key + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11").encode()).digest()
        if " 101 " not in status or fields.get("sec-websocket-accept") != base64.b64encode(proof).decode():
            raise ConnectionLost(f"The session has rejected the connection: {status}")

    @staticmethod
    def _take(length):
        buffer = bytearray(length)
        if length:
            yield memoryview(buffer)
        return buffer
