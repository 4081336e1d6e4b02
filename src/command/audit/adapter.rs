//! The graphics adapter that the audit runs WGSL on.

use crate::command::arguments::AuditArguments;
use crate::command::failure::Failure;
use etalon_audit::Device;

/// The adapter asked for, or else the best there is; if there is none, or none is wanted, that is said and figures on record have to do.
#[cfg(feature = "wgpu")]
pub fn find(arguments: &AuditArguments) -> Result<Option<Box<dyn Device>>, Failure> {
    if arguments.no_adapter {
        return Ok(None);
    }
    match etalon_wgpu::open(arguments.adapter.as_deref()) {
        Ok(device) => {
            eprintln!("WGSL runs on {}", device.adapter());
            Ok(Some(Box::new(Adapter(device))))
        }
        Err(error) if arguments.adapter.is_some() => Err(Failure::BadInput(error.to_string())),
        Err(error) => {
            eprintln!("WGSL is not run: {error}");
            Ok(None)
        }
    }
}

/// There is none.
#[cfg(not(feature = "wgpu"))]
pub fn find(arguments: &AuditArguments) -> Result<Option<Box<dyn Device>>, Failure> {
    const ABSENT: &str = "this program was built without graphics; build it with `--features wgpu`";
    if arguments.adapter.is_some() {
        return Err(Failure::BadInput(format!("--adapter: {ABSENT}")));
    }
    if !arguments.no_adapter {
        eprintln!("WGSL is not run: {ABSENT}");
    }
    Ok(None)
}

#[cfg(feature = "wgpu")]
struct Adapter(etalon_wgpu::Device);

#[cfg(feature = "wgpu")]
impl Device for Adapter {
    fn name(&self) -> String {
        self.0.adapter().to_string()
    }
    fn call(
        &self,
        function: &str,
        drawing: &etalon_kernels_gen::trace::Drawing,
        calls: usize,
        rows: &[f32],
    ) -> Result<Vec<f32>, String> {
        etalon_wgpu::call_function(&self.0, function, drawing, calls, rows).map_err(|error| error.to_string())
    }
}
