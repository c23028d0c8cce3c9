# Inserts the style and the script into a page, and writes the page to a C++ source as a string. Run
# with cmake -DPAGE=... -DSTYLE=... -DSCRIPT=... -DOUTPUT=... -P.
cmake_minimum_required(VERSION 3.25) # leaves @NAME@ alone
file(READ ${PAGE} page)
file(READ ${STYLE} style)
file(READ ${SCRIPT} script)

# Converts a SHA-256 digest (32 bytes, given in hex) to base64 (RFC 4648 section 4). Eleven groups
# of three bytes: the last group has one padding byte, whose digit is replaced by "=".
function(base64_of_sha256 hex output)
  set(digits "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/")
  set(text "")
  foreach(begin RANGE 0 60 6)
    string(SUBSTRING "${hex}00" ${begin} 6 three)
    foreach(shift 18 12 6 0)
      math(EXPR digit "(0x${three} >> ${shift}) & 63")
      string(SUBSTRING ${digits} ${digit} 1 digit)
      string(APPEND text ${digit})
    endforeach()
  endforeach()
  string(SUBSTRING ${text} 0 43 text)
  set(${output} "${text}=" PARENT_SCOPE)
endfunction()

# The page's Content-Security-Policy allows only the style and the script with these hashes.
foreach(part style script)
  string(SHA256 hex "${${part}}")
  base64_of_sha256(${hex} ${part}_hash)
endforeach()
string(REPLACE "@STYLE_HASH@" "${style_hash}" page "${page}")
string(REPLACE "@SCRIPT_HASH@" "${script_hash}" page "${page}")
string(REPLACE "@STYLE@" "${style}" page "${page}")
string(REPLACE "@SCRIPT@" "${script}" page "${page}")
file(WRITE ${OUTPUT} "#include \"report_page.h\"
const std::string_view lichen::kReportPage = R\"lichen_page(${page})lichen_page\";
")
