use super::*;
use crate::testing::Scratch;
use std::env;
use std::time::Duration;

fn key(i: usize) -> Key {
    Key::new("test", &i)
}

fn texts(i: usize) -> Vec<String> {
    vec![format!("text {i}"), "warning".to_owned()]
}

fn names(folder: &Folder) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(&folder.path)
        .expect("a folder")
        .map(|file| file.expect("a file").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// Gives a file a time of its own.
fn date(path: &Path, seconds: u64) {
    let file = File::options().append(true).open(path).expect("a file");
    file.set_modified(SystemTime::UNIX_EPOCH + Duration::from_secs(seconds)).expect("a time");
}

#[test]
fn put_and_get() {
    let scratch = Scratch::new("cache-put");
    let folder = Folder::at(scratch.path().join("deep/er"));
    assert_eq!(folder.get(&key(0)), None);
    folder.put(&key(0), &texts(0));
    folder.put(&key(1), &texts(1));
    assert_eq!((folder.get(&key(0)), folder.get(&key(1))), (Some(texts(0)), Some(texts(1))));
    folder.put(&key(0), &texts(2));
    assert_eq!(folder.get(&key(0)), Some(texts(2)));
    assert_eq!(names(&folder).len(), 2, "nothing is left over: {:?}", names(&folder));
}

#[test]
fn what_is_no_whole_entry_is_a_miss_and_mended() {
    let scratch = Scratch::new("cache-damaged");
    let folder = Folder::at(scratch.path());
    folder.put(&key(0), &texts(0));
    let whole = fs::read(folder.file(&key(0))).expect("an entry");
    folder.put(&key(1), &texts(1));
    let other = fs::read(folder.file(&key(1))).expect("an entry");
    let mut damaged = whole.clone();
    damaged[whole.len() / 2] ^= 4;
    let wrong: [&[u8]; 5] = [&[], b"text", &whole[..whole.len() - 1], &damaged, &other];
    for bytes in wrong {
        fs::write(folder.file(&key(0)), bytes).expect("a file");
        assert_eq!(folder.get(&key(0)), None);
        folder.put(&key(0), &texts(0));
        assert_eq!(folder.get(&key(0)), Some(texts(0)));
    }
    fs::remove_file(folder.file(&key(0))).expect("the entry");
    fs::create_dir(folder.file(&key(0))).expect("a folder in its place");
    folder.put(&key(0), &texts(0));
    assert_eq!(folder.get(&key(0)), None);
    assert_eq!(names(&folder).len(), 2, "nothing is left over: {:?}", names(&folder));
}

#[test]
fn where_nothing_can_be_written_nothing_is_kept() {
    let scratch = Scratch::new("cache-closed");
    let file = scratch.path().join("file");
    fs::write(&file, "no folder").expect("a file");
    let closed = scratch.path().join("closed");
    fs::create_dir(&closed).expect("a folder");
    let mut permissions = fs::metadata(&closed).expect("a folder").permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&closed, permissions).expect("permissions");
    for path in [&file, &file.join("in")] {
        let folder = Folder::at(path);
        folder.put(&key(0), &texts(0));
        assert_eq!(folder.get(&key(0)), None, "{}", path.display());
    }
    // Those who may do everything write there nevertheless.
    let folder = Folder::at(&closed);
    folder.put(&key(0), &texts(0));
    let kept = folder.get(&key(0));
    assert!(kept.is_none() || kept == Some(texts(0)));
}

#[test]
fn the_oldest_go_first_and_nobody_elses() {
    let scratch = Scratch::new("cache-bounded");
    let folder = Folder { path: scratch.path().to_owned(), bound: Bound { entries: 3, bytes: 1 << 20 } };
    for foreign in ["notes.entry", "sml-notes", "sml-1.unfinished.txt"] {
        fs::write(scratch.path().join(foreign), "").expect("a file");
        date(&scratch.path().join(foreign), 1);
    }
    // Of a process that was killed.
    fs::write(scratch.path().join("sml-0.7-0.unfinished"), "").expect("a file");
    date(&scratch.path().join("sml-0.7-0.unfinished"), 2);
    for i in 0..3 {
        folder.put(&key(i), &texts(i));
        date(&folder.file(&key(i)), 10 - i as u64);
    }
    assert_eq!(names(&folder).len(), 6, "{:?}", names(&folder));
    folder.put(&key(3), &texts(3));
    let known = |folder: &Folder| (0..4).filter(|&i| folder.get(&key(i)).is_some()).collect::<Vec<_>>();
    assert_eq!(known(&folder), [0, 1, 3]);
    assert_eq!(names(&folder).len(), 6, "{:?}", names(&folder));

    let length = fs::metadata(folder.file(&key(3))).expect("an entry").len();
    let narrow = Folder { bound: Bound { entries: 9, bytes: 2 * length }, ..folder };
    narrow.put(&key(3), &texts(3));
    assert_eq!(known(&narrow), [0, 3]);
    let large = ["x".repeat(2 * length as usize)];
    narrow.put(&key(2), &large);
    assert_eq!(known(&narrow), [0, 3], "what is larger than all may be does not drive out the others");
}

/// Names the folder to whom it is run by.
const SHARED: &str = "SYNTH_CORE_TEST_SHARED";

/// Two keys whose entries are of different lengths, written over and over. Nothing but what was put there is ever read.
#[test]
fn writes_and_reads() {
    let scratch;
    let path = match env::var_os(SHARED) {
        Some(path) => PathBuf::from(path),
        None => {
            scratch = Scratch::new("cache-alone");
            scratch.path().to_owned()
        }
    };
    let folder = Folder::at(path);
    let long = |i: usize| vec![format!("{i} ").repeat(1 + 20_000 * i), String::new()];
    let mut hits = 0;
    for round in 0..100 {
        let i = round % 2;
        if let Some(texts) = folder.get(&key(i)) {
            assert!(texts == long(i), "the entry of another");
            hits += 1;
        }
        folder.put(&key(i), &long(i));
    }
    assert!(hits > 90, "only {hits} hits");
}

#[test]
fn processes_share_a_folder() {
    let scratch = Scratch::new("cache-shared");
    let processes: Vec<_> = (0..2)
        .map(|_| {
            process::Command::new(env::current_exe().expect("this test"))
                .args(["--exact", "cache::folder::tests::writes_and_reads"])
                .env(SHARED, scratch.path())
                .stdout(process::Stdio::piped())
                .spawn()
                .expect("the same test")
        })
        .collect();
    for process in processes {
        let output = process.wait_with_output().expect("an end");
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(output.status.success() && said.contains("1 passed"), "{said}");
    }
    let folder = Folder::at(scratch.path());
    assert_eq!(names(&folder).len(), 2, "nothing is left over: {:?}", names(&folder));
    assert!(folder.get(&key(0)).is_some() && folder.get(&key(1)).is_some());
}
