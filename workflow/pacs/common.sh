# Functions of the scripts in this folder; sourced, not executed.
# shellcheck shell=bash

# shellcheck source-path=SCRIPTDIR
source "$(dirname "${BASH_SOURCE[0]}")/../../Utilities/common.sh"

here=$repository/workflow/pacs
declare -A pacs=([calling]=SHAPETON [timeout]=60)
temporary=$(mktemp -d)
tunnel=
part= # an incomplete folder
trap '[ -z "$tunnel" ] || kill "$tunnel" 2>/dev/null; rm -rf "$temporary" ${part:+"$part"}' EXIT

# read_pacs FILE: reads the description of a PACS, lines of name and value; see README.md. Paths are relative to it.
read_pacs() {
  local name value required folder
  folder=$(dirname "$1")
  [ -r "$1" ] || fail "cannot read $1; write the description of the PACS, see workflow/pacs/README.md" 3
  pacs[name]=$1
  while read -r name value; do
    case $name in
      '' | '#'*) ;;
      protocol | host | port | called | calling | url | timeout) pacs[$name]=$value ;;
      certificate | key | authority) pacs[$name]=$(cd "$folder" && realpath "$value") ;;
      *) fail "$1: unknown setting \"$name\"; see workflow/pacs/README.md" 2 ;;
    esac
  done <"$1"
  case ${pacs[protocol]-} in
    dicom) required="host port called" ;;
    dicom-tls) required="host port called certificate key authority" ;;
    dicomweb) required="url" ;;
    *) fail "$1: the protocol \"${pacs[protocol]-}\" is not one of dicom, dicom-tls, dicomweb" 2 ;;
  esac
  for name in $required; do
    [ -n "${pacs[$name]-}" ] || fail "$1: the setting \"$name\" is missing; it is required by ${pacs[protocol]}" 2
  done
}

# open_pacs FILE: reads the description and prepares the connection to the PACS.
open_pacs() {
  read_pacs "$1"
  [ "${pacs[protocol]}" != dicom-tls ] || open_tunnel
}

# open_tunnel: getscu and dcmsend of DCMTK 3.6.7 do not support TLS; they connect through stunnel, which checks the
# certificate.
open_tunnel() {
  local port
  for _ in 1 2 3 4 5; do
    port=$((10000 + RANDOM % 22000)) # below the range of ports that systems assign automatically
    start_tunnel "$port"
    until grep -q " bound to " "$temporary/stunnel.txt"; do
      kill -0 "$tunnel" 2>/dev/null || break
      sleep 0.05
    done
    grep -q "Address already in use" "$temporary/stunnel.txt" || break
  done
  kill -0 "$tunnel" 2>/dev/null || fail "stunnel: $(reason "$temporary/stunnel.txt"); check ${pacs[name]}"
  pacs[host]=127.0.0.1
  pacs[port]=$port
}

# start_tunnel PORT: starts stunnel, which ends with this script, even if it is killed.
start_tunnel() {
  cat >"$temporary/stunnel.conf" <<END
foreground = yes
debug = info
pid =
[pacs]
client = yes
accept = 127.0.0.1:$1
connect = ${pacs[host]}:${pacs[port]}
cert = ${pacs[certificate]}
key = ${pacs[key]}
CAfile = ${pacs[authority]}
verifyChain = yes
checkHost = ${pacs[host]}
END
  : >"$temporary/stunnel.txt"
  setpriv --pdeathsig TERM stunnel "$temporary/stunnel.conf" 2>>"$temporary/stunnel.txt" &
  tunnel=$!
}

# reason LOG: the first error lines of a tool; TLS errors come first.
reason() {
  { grep -ahE 'LOG3|certificate verify failed|VERIFY ERROR' "$temporary/stunnel.txt" 2>/dev/null || true
    grep -ahE '^(F|E|W):|^curl: |rejected|Reason' "$1" || tail -1 "$1"; } |
    sed -E 's/^[FEWI]: +(\* )?//; s/^.*LOG[0-9][^:]*: //' | head -3 | paste -sd ' ' | cut -c1-300
}

# dicom TOOL ARGUMENTS...: runs a DCMTK tool on the PACS; its log is $temporary/TOOL.txt.
dicom() {
  local tool=$1
  shift
  "$tool" -v -aet "${pacs[calling]}" -aec "${pacs[called]}" -to "${pacs[timeout]}" -ta "${pacs[timeout]}" -td "${pacs[timeout]}" \
    "$@" >"$temporary/$tool.txt" 2>&1
}

# web PATH CURL-ARGUMENTS...: DICOMweb request; prints the response, writes the log to $temporary/curl.txt.
web() {
  local path=$1
  shift
  curl --silent --show-error --fail --max-time "$((pacs[timeout] * 20))" --speed-limit 1 --speed-time "${pacs[timeout]}" \
    ${pacs[certificate]:+--cert "${pacs[certificate]}" --key "${pacs[key]}"} ${pacs[authority]:+--cacert "${pacs[authority]}"} \
    "${pacs[url]}/$path" "$@" 2>"$temporary/curl.txt" ||
    fail "${pacs[url]}: $(reason "$temporary/curl.txt"); check ${pacs[name]}"
}

# find_values LEVEL KEYWORD [KEY=VALUE...]: prints the values of a keyword in the PACS, one per line. findscu always exits
# with 0; only its last response shows success.
find_values() {
  local level=$1 keyword=$2 keys=()
  shift 2
  for key in "$@"; do keys+=(-k "$key"); done
  [[ $* == *$keyword=* ]] || keys+=(-k "$keyword")
  if [ "${pacs[protocol]}" = dicomweb ]; then
    find_by_web "$level" "$keyword" "$@"
    return
  fi
  if ! dicom findscu -S -k "QueryRetrieveLevel=$level" "${keys[@]}" "${pacs[host]}" "${pacs[port]}" ||
    ! grep -aq "Received Final Find Response (Success)" "$temporary/findscu.txt"; then
    fail "${pacs[called]}: no answer to a query: $(reason "$temporary/findscu.txt"); check ${pacs[name]}"
  fi
  tr -d '\0' <"$temporary/findscu.txt" | sed -n "/Find Response: /,\$s/^.*\[\([^]]*\)\] .* $keyword\$/\1/p" | sed 's/ *$//' | sort -u # \0 pads a UID
}

# find_by_web: find_values with QIDO-RS; given studies and series are part of the path.
find_by_web() {
  local level=$1 keyword=$2 path=studies query="includefield=$2&limit=100000"
  shift 2
  for key in "$@"; do
    case $level:$key in
      SERIES:StudyInstanceUID=* | IMAGE:StudyInstanceUID=*) path+=/${key#*=}/series ;;
      IMAGE:SeriesInstanceUID=*) path+=/${key#*=}/instances ;;
      *) query+="&$key" ;;
    esac
  done
  web "$path?$query" -H "Accept: application/dicom+json" >"$temporary/found.json"
  "$here/multipart.py" values "$keyword" "$temporary/found.json"
}

# instances_of STUDY SERIES: prints the SOP Instance UIDs in the PACS, sorted.
instances_of() { find_values IMAGE SOPInstanceUID "StudyInstanceUID=$1" "SeriesInstanceUID=$2"; }

# lines_of UIDS LIST: prints the lines of a list of uids.py with an instance in the file UIDS.
lines_of() { awk 'NR == FNR { wanted[$1]; next } $1 in wanted' "$1" "$2"; }

# missing_from WANTED FOUND: prints the lines of the first file that the second one lacks; both are sorted.
missing_from() { comm -23 "$1" "$2"; }

# fail_for MESSAGE NAMES: prints all names in the file NAMES, one per line, then the message with the first names.
fail_for() {
  cat "$2" >&2
  fail "$1: $(head -3 "$2" | paste -sd ' ')$([ "$(wc -l <"$2")" -le 3 ] || echo " and others, listed above")"
}
