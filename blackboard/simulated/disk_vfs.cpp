#include "blackboard/simulated/disk_vfs.hpp"

#include <algorithm>
#include <cstring>
#include <new>

#include "blackboard/simulated/disk_file.hpp"

namespace pizarra::simulated {

namespace {

// What SQLite has of an open file: its own part first.
struct Opened {
  sqlite3_file base;
  SimulatedDisk* disk;
  std::shared_ptr<DiskFile> file;
  std::uint64_t life;
  int level = SQLITE_LOCK_NONE;
  bool has_index = false;
  std::array<int, DiskFile::shared_locks> index_locks{};  // 1 shared, 2 exclusive
  bool deleted_at_close = false;
  std::string path;

  // Its process lives.
  bool is_attached() const { return life == disk->life(); }
};

Opened& opened(sqlite3_file* file) { return *reinterpret_cast<Opened*>(file); }

SimulatedDisk& disk_of(sqlite3_vfs* vfs) { return *static_cast<SimulatedDisk*>(vfs->pAppData); }

void unlock_to(Opened& of, int level) {
  DiskFile& file = *of.file;
  if (of.level >= SQLITE_LOCK_PENDING && level < SQLITE_LOCK_PENDING) file.exclusive = false;
  if (of.level >= SQLITE_LOCK_RESERVED && level < SQLITE_LOCK_RESERVED) file.reserved = false;
  if (of.level >= SQLITE_LOCK_SHARED && level < SQLITE_LOCK_SHARED) --file.shared;
  of.level = std::min(of.level, level);
}

void release_index(Opened& of) {
  if (!std::exchange(of.has_index, false)) return;
  for (std::size_t i = 0; i < of.index_locks.size(); ++i) {
    if (of.index_locks[i] == 1) --of.file->index_shared[i];
    if (of.index_locks[i] == 2) of.file->index_exclusive[i] = false;
    of.index_locks[i] = 0;
  }
  if (--of.file->index_users == 0) of.file->index.clear();
}

int close_file(sqlite3_file* file) {
  Opened& of = opened(file);
  if (of.is_attached()) {
    unlock_to(of, SQLITE_LOCK_NONE);
    release_index(of);
    if (of.deleted_at_close) of.disk->remove(of.path);
  }
  of.~Opened();
  return SQLITE_OK;
}

int read_file(sqlite3_file* file, void* to, int amount, sqlite3_int64 offset) {
  Opened& of = opened(file);
  if (!of.is_attached()) return SQLITE_IOERR_READ;
  const std::string& data = of.file->data;
  const auto size = static_cast<sqlite3_int64>(data.size());
  const sqlite3_int64 there = std::clamp<sqlite3_int64>(size - offset, 0, amount);
  if (there > 0) std::memcpy(to, data.data() + offset, static_cast<std::size_t>(there));
  if (there == amount) return SQLITE_OK;
  std::memset(static_cast<char*>(to) + there, 0, static_cast<std::size_t>(amount - there));
  return SQLITE_IOERR_SHORT_READ;
}

int write_file(sqlite3_file* file, const void* from, int amount, sqlite3_int64 offset) {
  Opened& of = opened(file);
  if (!of.is_attached() || of.disk->fails()) return SQLITE_IOERR_WRITE;
  if (!of.disk->has_space(*of.file, offset + amount)) return SQLITE_FULL;
  of.file->write(offset, {static_cast<const char*>(from), static_cast<std::size_t>(amount)});
  return SQLITE_OK;
}

int truncate_file(sqlite3_file* file, sqlite3_int64 size) {
  Opened& of = opened(file);
  if (!of.is_attached() || of.disk->fails()) return SQLITE_IOERR_TRUNCATE;
  of.file->cut(size);
  return SQLITE_OK;
}

int sync_file(sqlite3_file* file, int) {
  Opened& of = opened(file);
  if (!of.is_attached() || of.disk->fails()) return SQLITE_IOERR_FSYNC;
  of.disk->flush(*of.file);
  return SQLITE_OK;
}

int file_size(sqlite3_file* file, sqlite3_int64* size) {
  *size = static_cast<sqlite3_int64>(opened(file).file->data.size());
  return SQLITE_OK;
}

int lock_file(sqlite3_file* file, int level) {
  Opened& of = opened(file);
  if (!of.is_attached()) return SQLITE_IOERR_LOCK;
  DiskFile& its = *of.file;
  if (of.level >= level) return SQLITE_OK;
  if (of.level == SQLITE_LOCK_NONE) {
    if (its.exclusive) return SQLITE_BUSY;
    ++its.shared;
    of.level = SQLITE_LOCK_SHARED;
  }
  if (level >= SQLITE_LOCK_RESERVED && of.level < SQLITE_LOCK_RESERVED) {
    if (its.reserved) return SQLITE_BUSY;
    its.reserved = true;
    of.level = SQLITE_LOCK_RESERVED;
  }
  if (level == SQLITE_LOCK_EXCLUSIVE) {
    if (its.shared > 1) return SQLITE_BUSY;
    its.exclusive = true;
    of.level = SQLITE_LOCK_EXCLUSIVE;
  }
  return SQLITE_OK;
}

int unlock_file(sqlite3_file* file, int level) {
  if (opened(file).is_attached()) unlock_to(opened(file), level);
  return SQLITE_OK;
}

int check_reserved(sqlite3_file* file, int* reserved) {
  *reserved = opened(file).file->reserved ? 1 : 0;
  return SQLITE_OK;
}

int control(sqlite3_file*, int, void*) { return SQLITE_NOTFOUND; }
int sector_size(sqlite3_file*) { return 4096; }
int characteristics(sqlite3_file*) { return 0; }

int map_index(sqlite3_file* file, int region, int size, int extend, void volatile** at) {
  Opened& of = opened(file);
  if (!of.is_attached()) return SQLITE_IOERR_SHMMAP;
  if (!std::exchange(of.has_index, true)) ++of.file->index_users;
  auto& index = of.file->index;
  *at = nullptr;
  if (static_cast<std::size_t>(region) >= index.size()) {
    if (extend == 0) return SQLITE_OK;
    while (index.size() <= static_cast<std::size_t>(region)) {
      index.push_back(std::make_unique<std::string>(static_cast<std::size_t>(size), '\0'));
    }
  }
  *at = index[static_cast<std::size_t>(region)]->data();
  return SQLITE_OK;
}

int lock_index(sqlite3_file* file, int offset, int count, int flags) {
  Opened& of = opened(file);
  if (!of.is_attached()) return SQLITE_IOERR_SHMLOCK;
  DiskFile& its = *of.file;
  const auto first = static_cast<std::size_t>(offset);
  const auto last = first + static_cast<std::size_t>(count);
  const bool exclusive = (flags & SQLITE_SHM_EXCLUSIVE) != 0;
  for (std::size_t i = first; i < last && (flags & SQLITE_SHM_LOCK) != 0; ++i) {
    const int others = its.index_shared[i] - (of.index_locks[i] == 1 ? 1 : 0);
    const bool taken = its.index_exclusive[i] && of.index_locks[i] != 2;
    if (taken || (exclusive && others > 0)) return SQLITE_BUSY;
  }
  for (std::size_t i = first; i < last; ++i) {
    if (of.index_locks[i] == 1) --its.index_shared[i];
    if (of.index_locks[i] == 2) its.index_exclusive[i] = false;
    of.index_locks[i] = (flags & SQLITE_SHM_LOCK) == 0 ? 0 : exclusive ? 2 : 1;
    if (of.index_locks[i] == 1) ++its.index_shared[i];
    if (of.index_locks[i] == 2) its.index_exclusive[i] = true;
  }
  return SQLITE_OK;
}

void order_index(sqlite3_file*) {}

int unmap_index(sqlite3_file* file, int) {
  if (opened(file).is_attached()) release_index(opened(file));
  return SQLITE_OK;
}

constexpr sqlite3_io_methods methods = {.iVersion = 2,
                                        .xClose = close_file,
                                        .xRead = read_file,
                                        .xWrite = write_file,
                                        .xTruncate = truncate_file,
                                        .xSync = sync_file,
                                        .xFileSize = file_size,
                                        .xLock = lock_file,
                                        .xUnlock = unlock_file,
                                        .xCheckReservedLock = check_reserved,
                                        .xFileControl = control,
                                        .xSectorSize = sector_size,
                                        .xDeviceCharacteristics = characteristics,
                                        .xShmMap = map_index,
                                        .xShmLock = lock_index,
                                        .xShmBarrier = order_index,
                                        .xShmUnmap = unmap_index,
                                        .xFetch = nullptr,
                                        .xUnfetch = nullptr};

int open_file(sqlite3_vfs* vfs, sqlite3_filename name, sqlite3_file* file, int flags, int* given) {
  SimulatedDisk& disk = disk_of(vfs);
  const std::string path = name == nullptr ? "temporary" : name;
  std::shared_ptr<DiskFile> found = disk.find(path);
  if (found == nullptr && ((flags & SQLITE_OPEN_CREATE) == 0 || disk.fails())) {
    file->pMethods = nullptr;
    return SQLITE_CANTOPEN;
  }
  if (found == nullptr) found = disk.find_or_make(path);
  Opened* const of = new (file) Opened{
      .base = {.pMethods = &methods}, .disk = &disk, .file = std::move(found), .life = disk.life(), .path = path};
  of->deleted_at_close = (flags & SQLITE_OPEN_DELETEONCLOSE) != 0;
  if (given != nullptr) *given = flags;
  return SQLITE_OK;
}

int delete_file(sqlite3_vfs* vfs, const char* name, int) {
  if (disk_of(vfs).fails()) return SQLITE_IOERR_DELETE;
  return disk_of(vfs).remove(name) ? SQLITE_OK : SQLITE_IOERR_DELETE_NOENT;
}

int is_there(sqlite3_vfs* vfs, const char* name, int, int* result) {
  *result = disk_of(vfs).find(name) != nullptr ? 1 : 0;
  return SQLITE_OK;
}

int full_path(sqlite3_vfs*, const char* name, int size, char* to) {
  sqlite3_snprintf(size, to, "%s", name);
  return SQLITE_OK;
}

// Names of temporary files alone.
int draw_random(sqlite3_vfs* vfs, int bytes, char* to) {
  for (int i = 0; i < bytes; ++i) to[i] = static_cast<char>(disk_of(vfs).random().below(256));
  return bytes;
}

// Nobody waits in virtual time for who runs on the same thread.
int sleep_some(sqlite3_vfs*, int microseconds) { return microseconds; }

int tell_time(sqlite3_vfs*, double* day) {
  *day = 2440587.5;  // 1970
  return SQLITE_OK;
}

int last_error(sqlite3_vfs*, int, char*) { return 0; }

}  // namespace

sqlite3_vfs vfs_of(SimulatedDisk& disk, const char* name) {
  sqlite3_vfs vfs{};
  vfs.iVersion = 1;
  vfs.szOsFile = sizeof(Opened);
  vfs.mxPathname = 512;
  vfs.zName = name;
  vfs.pAppData = &disk;
  vfs.xOpen = open_file;
  vfs.xDelete = delete_file;
  vfs.xAccess = is_there;
  vfs.xFullPathname = full_path;
  vfs.xRandomness = draw_random;
  vfs.xSleep = sleep_some;
  vfs.xCurrentTime = tell_time;
  vfs.xGetLastError = last_error;
  return vfs;
}

}  // namespace pizarra::simulated
