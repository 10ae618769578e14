//! Exploration on disk finds what exploration in memory finds, however little memory it has and however often it is interrupted.

use sml_tests::random::{Options as RandomOptions, specification};
use sml_tests::{corpus, families, fast};
use std::cell::Cell;
use std::fs;
use std::path::{Path, PathBuf};
use synth_core::explore::{ExploreError, Limits};
use synth_core::external::{Budget, Census, ExternalError, Origin, Task, explore};
use synth_core::pipeline::Failure;
use synth_core::playout::Semantics;

/// So little that most duplicates are written and many files are merged.
const TINY: Budget = Budget { recent: 64, candidates: 700, checkpoint: 300 };

/// A folder that is not there yet.
fn scratch(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("external").join(name);
    let _ = fs::remove_dir_all(&folder);
    folder
}

struct Run<'t> {
    text: &'t str,
    classic: bool,
    folder: &'t Path,
    limits: Limits,
    budget: Budget,
}

impl<'t> Run<'t> {
    fn new(text: &'t str, folder: &'t Path) -> Self {
        Run { text, classic: false, folder, limits: Limits::default(), budget: TINY }
    }

    fn explore(&self, stop: &dyn Fn() -> bool) -> Result<Census, ExternalError> {
        let spec = fast::resolved(self.text).expect("a specification");
        let semantics = Semantics { classic: self.classic };
        let origin = Origin::new(&fast::loaded(self.text).sources, semantics);
        let task = Task { folder: self.folder, origin: &origin, budget: self.budget, stop };
        explore(&spec, semantics, &self.limits, &task)
    }

    #[track_caller]
    fn census(&self) -> Census {
        self.explore(&|| false).expect("a census")
    }
}

/// The same counts as in memory, or the same kind of mistake.
#[track_caller]
fn check(name: &str, text: &str) {
    let spec = fast::resolved(text).expect("a specification");
    for classic in [false, true] {
        let folder = scratch(&format!("{name}_{classic}"));
        let mut run = Run { classic, ..Run::new(text, &folder) };
        let found = run.explore(&|| false);
        match (fast::solved(&spec, &fast::options(classic, 100_000)), found) {
            (Ok(solved), Ok(census)) => {
                let figures = solved.figures();
                let numbers = [
                    (census.states, figures.states),
                    (census.transitions, figures.transitions),
                    (census.system_states, figures.system_states),
                    (census.environment_states, figures.environment_states),
                    (census.yielded_states, figures.yielded_states),
                    (census.idle_states, figures.idle_states),
                    (census.assumption_sets, figures.assumption_sets),
                    (census.guarantee_sets, figures.guarantee_sets),
                ];
                for (index, (disk, memory)) in numbers.into_iter().enumerate() {
                    assert_eq!(disk, memory as u64, "{name}, classic {classic}, number {index}\n{text}");
                }
                assert_eq!(run.census(), census, "{name}: finished");
                fs::remove_dir_all(&folder).expect("removed");
                run.budget = Budget::of(1 << 20);
                run.limits.threads = 1;
                assert_eq!(run.census(), census, "{name}: memory does not show");
            }
            (Err(Failure::Wrong(wrong)), Err(ExternalError::Explore(ExploreError::Play(error, play)))) => {
                let diagnostic = error.diagnostic(&play);
                assert_eq!(diagnostic.code, wrong[0].code, "{name}, classic {classic}\n{text}");
                let lines =
                    |d: &synth_core::diagnostic::Diagnostic| format!("{:?}", d.notes).matches("\\n").count();
                assert_eq!(lines(&diagnostic), lines(&wrong[0]), "{name}: plays of the same length");
            }
            (memory, disk) => panic!("{name}, classic {classic}: {memory:?}, {disk:?}\n{text}"),
        }
        fs::remove_dir_all(&folder).expect("removed");
    }
}

#[test]
fn counts_on_the_corpus() {
    for entry in corpus::all() {
        if fast::resolved(&entry.text).is_ok() {
            check(&entry.name, &entry.text);
        }
    }
}

#[test]
fn counts_on_random_specifications() {
    for seed in 0..60 {
        check(&format!("seed_{seed}"), &specification(seed, RandomOptions::default()));
    }
}

/// What is found several times comes at the edge of a block, too.
#[test]
fn counts_where_files_have_many_blocks() {
    let text = families::arbiter(12);
    let folder = scratch("blocks");
    let census = Run { budget: Budget::of(1 << 30), ..Run::new(&text, &folder) }.census();
    let (clients, all) = (12_u64, 1 << 12);
    assert_eq!(census.states, 2 * all - 1 + clients * all / 2);
}

/// So many switches that each can be turned at any time.
fn switches(count: usize) -> String {
    let objects: String = (1..=count).map(|n| format!("  object switch{n}: Switch\n")).collect();
    format!(
        "specification Switches {{
  domain d {{ class Control {{ turned() }} class Switch {{ on: bool  confirm() }} }}
  object control: Control
{objects}  controllable {{ Control }}
  effects {{ Switch -> Control.turned() {{ sender.on = !sender.on }} }}
  collaboration C {{
    dynamic role Switch switch
    guarantee scenario G {{ switch -> control.turned() urgent control -> switch.confirm() }}
  }}
}}"
    )
}

/// Goes on whenever it is interrupted, which is each time when it has asked so many times.
#[track_caller]
fn in_pieces(run: &Run<'_>, asked: usize) -> (Census, usize) {
    for pieces in 1..10_000 {
        let left = Cell::new(asked);
        let stop = || {
            left.set(left.get().saturating_sub(1));
            left.get() == 0
        };
        match run.explore(&stop) {
            Ok(census) => return (census, pieces),
            Err(ExternalError::Stopped(progress)) => {
                assert!(progress.explored <= progress.states, "{progress:?}");
            }
            Err(error) => panic!("{error:?}"),
        }
    }
    panic!("it never ends");
}

#[test]
fn interruptions_do_not_show() {
    let entry = corpus::all().into_iter().find(|entry| entry.name == "production_cell").expect("the cell");
    for (name, text) in [("cell", entry.text), ("switches", switches(6))] {
        let folder = scratch(&format!("whole_{name}"));
        let whole = Run::new(&text, &folder).census();
        for asked in [1, 2, 3] {
            let folder = scratch(&format!("pieces_{name}_{asked}"));
            let (census, pieces) = in_pieces(&Run::new(&text, &folder), asked + 1);
            assert_eq!(census, whole, "{name}: a piece for each {asked}");
            assert!(pieces > 1, "{pieces}");
        }
    }
}

/// Layers of several batches, whose second half is explored after the interruption.
#[test]
fn interruptions_within_a_layer_do_not_show() {
    let text = switches(13);
    let folder = scratch("layers");
    let mut run = Run::new(&text, &folder);
    run.budget = Budget { recent: 1 << 10, candidates: 1 << 16, checkpoint: 1 << 14 };
    let (census, pieces) = in_pieces(&run, 5);
    assert_eq!((census.states, census.transitions), (14 << 13, (13 << 13) * 2));
    assert!(pieces > 5, "{pieces}");
}

/// A process that is killed leaves files that no checkpoint names, and perhaps half a checkpoint.
#[test]
fn what_a_killed_process_leaves_does_not_count() {
    let text = switches(6);
    let (folder, whole) = (scratch("killed"), scratch("not_killed"));
    let run = Run::new(&text, &folder);
    let asked = Cell::new(0);
    let stopped = run.explore(&|| {
        asked.set(asked.get() + 1);
        asked.get() == 4
    });
    assert!(matches!(stopped, Err(ExternalError::Stopped(_))), "{stopped:?}");
    fs::write(folder.join("sml-99999999.rows"), "half").expect("written");
    fs::write(folder.join("sml.checkpoint.unfinished"), "half").expect("written");
    fs::write(folder.join("notes.txt"), "somebody's").expect("written");
    assert_eq!(run.census(), Run::new(&text, &whole).census());
    assert!(!folder.join("sml-99999999.rows").exists() && folder.join("notes.txt").exists());
}

#[test]
fn a_limit_of_states_can_be_raised() {
    let text = switches(6);
    let (folder, whole) = (scratch("limited"), scratch("unlimited"));
    let mut run = Run::new(&text, &folder);
    run.limits.states = 100;
    let limited = run.explore(&|| false);
    let Err(ExternalError::Explore(ExploreError::Limit(limit))) = limited else { panic!("{limited:?}") };
    assert!(limit.what == "states" && limit.states > 100 && limit.explored < limit.states, "{limit:?}");
    run.limits = Limits::default();
    assert_eq!(run.census(), Run::new(&text, &whole).census());
    run.limits.memory = 1000;
    fs::remove_dir_all(&folder).expect("removed");
    let limited = run.explore(&|| false);
    assert!(
        matches!(&limited, Err(ExternalError::Explore(ExploreError::Limit(limit))) if limit.what == "memory"),
        "{limited:?}"
    );
}

#[test]
fn checkpoints_of_something_else_are_refused() {
    let (one, other) = (switches(3), switches(4));
    let folder = scratch("other");
    Run::new(&one, &folder).census();
    let before = fs::read(folder.join("sml.checkpoint")).expect("a checkpoint");
    let what = |run: Run<'_>| match run.explore(&|| false) {
        Err(ExternalError::Other(path, what)) => {
            assert_eq!(path, folder.join("sml.checkpoint"));
            what
        }
        other => panic!("{other:?}"),
    };
    assert_eq!(what(Run::new(&other, &folder)), "another specification");
    assert_eq!(what(Run { classic: true, ..Run::new(&one, &folder) }), "other options");
    assert_eq!(fs::read(folder.join("sml.checkpoint")).expect("a checkpoint"), before);
}

/// Every byte of every file, and every length: a message that names the file, or a result that does not depend on it.
#[test]
fn damaged_files_are_told() {
    let text = switches(5);
    let (folder, damaged) = (scratch("sound"), scratch("damaged"));
    let asked = Cell::new(0);
    let run = Run::new(&text, &folder);
    let stopped = run.explore(&|| {
        asked.set(asked.get() + 1);
        asked.get() == 6
    });
    assert!(matches!(stopped, Err(ExternalError::Stopped(_))), "{stopped:?}");
    let files: Vec<_> =
        fs::read_dir(&folder).expect("a folder").map(|file| file.expect("a file").path()).collect();
    let mut told = 0;
    for path in &files {
        let bytes = fs::read(path).expect("a file");
        let step = (bytes.len() / 60).max(1);
        for place in (0..bytes.len()).step_by(step) {
            for cut in [false, true] {
                let _ = fs::remove_dir_all(&damaged);
                fs::create_dir_all(&damaged).expect("a folder");
                for file in &files {
                    fs::copy(file, damaged.join(file.file_name().expect("a name"))).expect("a copy");
                }
                let mut wrong = bytes.clone();
                if cut {
                    wrong.truncate(place);
                } else {
                    wrong[place] ^= 0x41;
                }
                fs::write(damaged.join(path.file_name().expect("a name")), wrong).expect("written");
                match Run::new(&text, &damaged).explore(&|| false) {
                    Err(ExternalError::Damaged(at, what)) => {
                        assert_eq!(at.file_name(), path.file_name(), "{what}");
                        told += 1;
                    }
                    // Layers that were explored are read again only to show a play.
                    Ok(census) => assert!(!cut && census.states == 6 << 5, "{}", path.display()),
                    Err(error) => panic!("{}: {error:?}", path.display()),
                }
            }
        }
    }
    assert!(told > 100, "{told}");
}

#[test]
fn a_folder_that_cannot_be_made() {
    let file = scratch("file");
    fs::create_dir_all(file.parent().expect("a folder")).expect("a folder");
    fs::write(&file, "").expect("a file");
    let found = Run::new(&switches(2), &file).explore(&|| false);
    assert!(matches!(&found, Err(ExternalError::Write(path, _)) if *path == file), "{found:?}");
    fs::remove_file(&file).expect("removed");
}

#[test]
fn counts_of_a_family() {
    let line = families::by_name("line").expect("a family");
    check("line", &(line.text)(line.least));
}
