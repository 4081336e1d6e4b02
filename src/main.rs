//! The program `etalon`. See [`etalon::command`].
#![forbid(unsafe_code)]

fn main() -> std::process::ExitCode {
    etalon::command::main(std::env::args_os())
}
