/// <reference path="../../www/node_modules/vite/client.d.ts" />
/// <reference path="../../www/src/papers/modules.d.ts" />
/// <reference path="../../www/src/lab/published/modules.d.ts" />
