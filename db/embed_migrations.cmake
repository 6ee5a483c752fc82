# cmake -D FOLDER=... -D OUT=... -P embed_migrations.cmake
# Writes the numbered .sql files of FOLDER into one source file, so that the executable needs
# no file beside itself.
file(GLOB files RELATIVE ${FOLDER} ${FOLDER}/*.sql)
list(SORT files)
set(rows "")
set(expected 1)
foreach(file IN LISTS files)
  if(NOT file MATCHES "^([0-9][0-9][0-9][0-9])_[a-z0-9_]+\\.sql$")
    message(FATAL_ERROR "${FOLDER}/${file}: a migration is named 0001_what_it_does.sql")
  endif()
  math(EXPR number "1${CMAKE_MATCH_1} - 10000")
  if(NOT number EQUAL expected)
    message(FATAL_ERROR "${FOLDER}/${file}: number ${expected} should come here")
  endif()
  math(EXPR expected "${expected} + 1")
  file(READ ${FOLDER}/${file} sql)
  string(APPEND rows "    {${number}, \"${file}\", R\"sql(${sql})sql\"},\n")
endforeach()
file(WRITE ${OUT}
"// Written by db/embed_migrations.cmake from db/migrations.
#include \"db/migrate.hpp\"

namespace leda::db {

const std::vector<Migration>& migrations() {
  static const std::vector<Migration> all = {
${rows}  };
  return all;
}

}  // namespace leda::db
")
