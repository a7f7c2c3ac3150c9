var il=class{#t;#e=new Map;#n=[];#i=!1;constructor(t){this.#t=t}shownIn(t,e){this.#n.push(e),this.#e.set(t,!1),new IntersectionObserver(n=>{this.#e.set(t,n[n.length-1].isIntersecting),this.#s()}).observe(t)}#s(){let t=[...this.#e.values()].includes(!0);if(t===this.#i)return;this.#i=t;let e=(n,s)=>this.#n.forEach(r=>r(n,s));this.#t.sampleActivity(t?e:null)}};var Wo=class{constructor(t){this.name=t}toString(){return this.name}},Wt=i=>new Wo(i),J=i=>i instanceof Wo?i.name:typeof i=="string"?i:"",ep=/\s*(?:;[^\n]*\n\s*)*(\(|\)|"(?:[^"\\]|\\.)*"|[^\s()";]+)/y,lx={n:`
`,t:"	"};function cx(i){return i[0]==='"'?i.slice(1,-1).replace(/\\(.)/gs,(t,e)=>lx[e]??e):/^[-+]?\d/.test(i)?Number(i):new Wo(i)}function ni(i){ep.lastIndex=0;let t=[[]];for(;;){let e=ep.exec(i);if(!e)break;if(e[1]==="(")t.push([]);else if(e[1]===")"){let n=t.pop();if(t.length===0)return[];t[t.length-1].push(n)}else t[t.length-1].push(cx(e[1]))}return t[0][0]??[]}var hx=i=>`"${i.replace(/[\\"]/g,"\\$&").replace(/\n/g,"\\n").replace(/\t/g,"\\t").replace(/[\0-\x08\x0b-\x1f]/g," ")}"`;function we(i){return Array.isArray(i)?`(${i.map(we).join(" ")})`:typeof i=="string"?hx(i):String(i)}var sl=class{#t;#e=null;#n=null;#i=null;constructor(t){this.#t=t}open(){this.#e&&this.#t.say(Wt("truth")),this.#n&&this.#t.say(Wt("activity")),this.#i&&this.#t.say(Wt("work"),this.#t.number())}hear(t){"truth"in t?this.#e?.(t.truth===null?null:ni(t.truth),t.said):"activity"in t?this.#n?.(t.activity,t.said):this.#i?.(t.work,t.changes)}layTruth(t){this.#e=t,this.#t.say(Wt(t?"truth":"truth-no-more"))}sampleActivity(t){this.#n=t,this.#t.say(Wt(t?"activity":"activity-no-more"))}earlierWork(t){this.#i=t,this.#t.say(Wt("work"),this.#t.number())}};var rl=class{#t;#e;#n;#i=0;stamp=0;constructor(t,e,n){this.#t=t,this.#e=e,this.#n=n}jog(t,e){this.#i=this.#t.number();let n=[Wt(t),Wt(e),this.stamp];return this.#s("jog",...n),this.#e.callAs(this.#i,null,"jog",...n)}holdOn(){this.#t.say(Wt("hold-on"),this.#i,this.stamp),this.#s("hold-on",this.stamp)}release(){this.#t.say(Wt("release"),this.#i),this.#s("release")}#s(t,...e){this.#n.say(we([Wt(t),this.#i,...e]))}};var ux=1e3,pu=i=>{let t=new WebSocket(`${location.protocol.replace("http","ws")}//${location.host}${i}`);return t.binaryType="arraybuffer",t},ol=class{#t;#e=new Set;constructor(t){this.#t=t}open({path:t,lanes:e}){this.close();for(let n=0;n<e;++n)this.#n(t)}close(){let t=this.#e;this.#e=new Set;for(let e of t)e.close()}say(t){[...this.#e].find(({readyState:n})=>n===WebSocket.OPEN)?.send(t)}#n(t){let e=this.#e,n=pu(t);e.add(n),n.onmessage=async({data:s})=>{let r=performance.now();await this.#t(s),n.send(we([Wt("drawn"),Math.round(performance.now()-r)]))},n.onclose=()=>{e.delete(n),setTimeout(()=>e===this.#e&&this.#n(t),ux)}}};var fx=5e6;async function mu(i){let t=new Uint8Array(i),e=t.indexOf(10),[,n,s,r,o,a]=ni(new TextDecoder().decode(t.subarray(0,e))),l=new Blob([t.subarray(e+1)],{type:"image/jpeg"}),c=await createImageBitmap(l).catch(()=>null);return[n,c&&{bitmap:c,number:s,captured:r,width:o,height:a}]}var al=class{#t;#e=new Map;#n=new Map;lanes=new ol(t=>this.#i(t));constructor(t){this.#t=t}open(t){this.lanes.open(t);for(let e of this.#e.keys())this.#t.say(Wt("look"),Wt(e))}lost(){this.lanes.close()}add(t,e){return this.#e.set(t,e),this.#t.say(Wt("look"),Wt(t)),()=>{this.#e.delete(t),this.#t.say(Wt("look-away"),Wt(t))}}async#i(t){let[e,n]=await mu(t);if(await new Promise(requestAnimationFrame),!n)return;let{captured:s}=n,r=this.#n.get(J(e))??0;(s>=r||r-s>fx)&&(this.#n.set(J(e),s),this.#e.get(J(e))?.(n)),n.bitmap.close()}};var ll=class{#t=new Map;#e;constructor(t){this.#e=t}change(t){t.resynchronised&&this.#t.clear();for(let e of t.removed)this.#t.delete(e.join());for(let e of t.added)this.#t.set(e.ids.join(),e);this.#e([...this.#t.values()],t)}};function dt(i){return i.read??=ni(i.facts[0].text),i.read}var dx=4,cl=class{#t;#e=new Map;#n=new Map;#i=new Map;moment=null;constructor(t){this.#t=t}open(){for(let[t,e]of this.#e)this.#s(t,e)}lost(){for(let t of this.#i.values())t({error:this.#t.notConnected});this.#i.clear()}hear(t){let e=this.#e.get(t.watch);(t.past??null)===(e?.always?null:this.moment)&&e?.take(t),t.past&&this.#i.get(t.watch)?.(t)}refused(t,e){this.#i.get(t)?.(e),this.#e.get(t)?.take(e)}#s(t,e){e.once?this.#t.say(Wt("ask"),t,ni(e.query)):e.typed?this.#t.say(Wt("watch"),t,e.query):this.#t.say(Wt("follow"),t,ni(e.query))}#r(t,e,n,s,r=!1){let o=this.#t.number(),a=new ll(n),l={query:t,typed:e,always:r,take:c=>"error"in c?s(c.error):a.change(c)};return this.#e.set(o,l),this.#s(o,l),()=>{this.#e.delete(o),this.#t.say(Wt("unwatch"),o)}}follow(t,e,n=!1){let s=`${n} ${t}`,r=this.#n.get(s)??{listeners:[],told:null};if(r.listeners.push(e),r.told&&e(...r.told),this.#n.has(s))return;this.#n.set(s,r);let o=(...a)=>{r.told=a;for(let l of r.listeners)l(...a)};this.#r(t,!1,o,()=>{},n)}watch(t,e,n){return this.#r(t,!0,e,n)}ask(t){let e=this.#t.number();return new Promise(n=>{let s=o=>{this.#e.delete(e),n("error"in o?[]:o.added)},r={query:we(t),once:!0,take:s,always:!0};this.#e.set(e,r),this.#s(e,r)})}async askThen(t,e){let n=this.#t.number(),s=await this.#a(n,t,e);if(this.#i.delete(n),"error"in s)throw s.error;return s.added}async showMoment(t){this.moment=t;let e=[...this.#e].filter(([,n])=>!n.always);if(t!==null)return this.#o(e,t);for(let[n,s]of e)this.#t.say(Wt("unwatch"),n),this.#s(n,s);return null}async#o(t,e){let n=null,s=async()=>{for(let r=t.shift();r&&this.moment===e;r=t.shift()){let[o,a]=r,l=await this.#a(o,a.query,e);if(!("error"in l))continue;l.error.symbol==="undeclared-relation"?a.take({resynchronised:!0,cut:0,removed:[],added:[]}):n??=l.error}};return await Promise.all(Array.from({length:dx},s)),n}#a(t,e,n){return new Promise(s=>{this.#i.set(t,s),this.#t.say(Wt("then"),t,ni(e),n)||s({error:this.#t.notConnected})})}};var px={symbol:"unreachable",sentence:"the console has gone; whether it was done is not known"},hl=class{#t;#e=new Map;constructor(t){this.#t=t}lost(){for(let{reject:t}of this.#e.values())t(px);this.#e.clear()}hear(t,e){this.#e.get(t)?.take(e)}call(t,...e){return this.callAs(this.#t.number(),null,t,...e)}callWith(t,e,...n){return this.callAs(this.#t.number(),t,e,...n)}callAs(t,e,n,...s){return new Promise((r,o)=>{let a=l=>{e&&!("error"in l)?this.#e.set(t,{reject:()=>{},take:c=>this.#n(t,e,c)}):this.#e.delete(t),"error"in l?o(l.error):r(l.values)};this.#e.set(t,{reject:o,take:a}),!this.#t.say(Wt(n),t,...s)&&(this.#e.delete(t),o(this.#t.notConnected))})}#n(t,e,n){this.#e.delete(t),e(n)}};var ul=class{#t;#e;#n=0;#i=!1;constructor(t){this.#t=t}begin(){this.end(),this.#i=!1,this.#n=performance.now(),this.#e=setInterval(()=>this.#s(),250)}end(){clearInterval(this.#e)}heard(){this.#n=performance.now(),this.#i&&this.#s()}#s(){let t=performance.now()-this.#n,e=this.#i;this.#i=t>2500,this.#i?this.#t("silent",`for ${Math.floor(t/1e3)} s`):e&&this.#t("live")}};var np=500,mx=4e3,gx=5,fl=class{#t=null;#e=1;#n=np;#i=0;#s={say:(...t)=>this.#h(...t),number:()=>this.#e++,notConnected:{symbol:"unreachable",sentence:"the console is not connected"}};#r=new cl(this.#s);#o=new hl(this.#s);#a=new al(this.#s);#l=new rl(this.#s,this.#o,this.#a.lanes);#c=new sl(this.#s);#u=new ul((t,e)=>this.onState(t,e));onState=()=>{};onHello=()=>{};onArm=()=>{};onPulse=()=>{};async open(){let t=location.hash.slice(1);t&&history.replaceState(null,"",location.pathname),await this.logIn(t)}async logIn(t){t&&await fetch("/session",{method:"POST",headers:{Authorization:`Bearer ${t}`}}).catch(()=>null),this.#f()}async logOut(){await fetch("/socket",{method:"DELETE"}).catch(()=>null),location.reload()}#f(){this.onState("connecting");let t=pu("/socket");t.onmessage=e=>typeof e.data=="string"?this.#p(JSON.parse(e.data)):this.#m(e.data),t.onclose=({reason:e})=>this.#d(e),this.#t=t}async#d(t){this.#t=null,this.#i=0,this.#l.stamp=0,this.#u.end();for(let n of[this.#a,this.#r,this.#o])n.lost();if((await fetch("/socket").catch(()=>null))?.status===403)return this.onState("refused");this.onState("lost",t),setTimeout(()=>this.#f(),this.#n),this.#n=Math.min(this.#n*2,mx)}#h(...t){return this.#t?.readyState!==WebSocket.OPEN?!1:(this.#t.send(we(t)),!0)}#p(t){"error"in t&&(t.error.said=t.said),"hello"in t?this.#g(t.hello):"pulse"in t?this.#_(t):"reply"in t?(this.#o.hear(t.reply,t),"error"in t&&this.#r.refused(t.reply,t)):("watch"in t?this.#r.hear(t):"arm"in t?(t.past??null)===this.moment&&this.onArm(t):this.#c.hear(t),"error"in t||this.#x())}#g(t){this.#n=np,this.onHello(t),this.onState("live"),this.#u.begin(),this.#a.open(t.images);for(let e of[this.#r,this.#c])e.open()}#_(t){this.#l.stamp=t.pulse,this.#u.heard(),this.#h(Wt("stamp"),t.pulse),this.onPulse(t)}#x(){this.#i++>0||setTimeout(()=>{this.#h(Wt("heard"),this.#i),this.#i=0},gx)}get moment(){return this.#r.moment}showMoment=this.#r.showMoment.bind(this.#r);follow(t,e){this.#r.follow(t,e)}followAlways(t,e){this.#r.follow(t,e,!0)}watch=this.#r.watch.bind(this.#r);ask=this.#r.ask.bind(this.#r);askThen=this.#r.askThen.bind(this.#r);request(t,e){return this.#o.call("request",Wt(t),typeof e=="string"?ni(e):e)}goal(t,e){return this.#o.callWith(e,"goal",t)}stop(t){return this.#o.call("stop",t)}clearStops(){return this.#o.call("clear-stops")}hold(t,e){return this.#o.call(t,Wt(e))}async cells(){let[t]=await this.#o.call("cells");return JSON.parse(t)}async method(t){let[e]=await this.#o.call("method",t);return JSON.parse(e)}jog=this.#l.jog.bind(this.#l);holdOn=this.#l.holdOn.bind(this.#l);release=this.#l.release.bind(this.#l);layTruth=this.#c.layTruth.bind(this.#c);sampleActivity=this.#c.sampleActivity.bind(this.#c);earlierWork=this.#c.earlierWork.bind(this.#c);look=this.#a.add.bind(this.#a);async picture(t,e){let[n]=await this.#o.call("picture",Wt(t),e);return n}async#m(t){let[e,n]=await mu(t);this.#o.hear(e,n?{values:[n]}:{error:{sentence:"what was kept is no picture"}})}};var Rt=i=>document.getElementById(i),R=(i,t,...e)=>ip(document.createElement(i),t,e),Sn=(i,t,...e)=>ip(document.createElementNS("http://www.w3.org/2000/svg",i),t,e);function ip(i,t,e){for(let[n,s]of Object.entries(t))typeof s=="function"?i.addEventListener(n.slice(2),s):s===!0?i.setAttribute(n,""):s!==!1&&s!=null&&i.setAttribute(n,String(s));return i.append(...e.filter(n=>n!=null)),i}var Ki=i=>i.getContext("2d");function dl(i,t){let e=new Set(t);for(let n of[...i.children])e.has(n)||n.remove();t.forEach((n,s)=>{let r=i.children[s];r!==n&&i.insertBefore(n,r??null)})}var Jt=(i,t=300)=>i.length>t?`${i.slice(0,t)} \u2026 (${i.length} characters)`:i,tn=i=>new Date(i/1e3).toLocaleTimeString("en-GB",{hour12:!1}),Te=i=>Jt(i.said??i.sentence??String(i),1600);function ii(i){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,i()}))}}function pl(i){let t=Rt("confirm");return Rt("confirm-text").textContent=i,t.showModal(),new Promise(e=>{let n=new AbortController,s=r=>{n.abort(),e(r)};t.addEventListener("submit",r=>s(r.submitter?.getAttribute("value")==="yes"),{signal:n.signal}),t.addEventListener("close",()=>t.open||s(!1),{signal:n.signal})})}var ml=class{#t;#e=[];#n=[];#i=[];#s="";#r=!1;#o=!1;#a=!1;change=null;live=!1;me="";robot="robot";constructor(t){this.#t=t,t.followAlways("(commander ?robot ?client)",e=>{this.#n=e.map(dt),this.#l(),this.changed()}),t.followAlways("(commander-wanted ?robot ?client)",e=>{this.#i=e.map(dt),this.changed()})}get holder(){let t=this.#n.find(e=>J(e[1])===this.robot);return t?J(t[2]):""}get mine(){return this.live&&this.me!==""&&this.holder===this.me}get why(){return this.live?this.mine?"":"Take the arm in hand first":"There is no live line to the console"}get askers(){return this.#i.filter(e=>J(e[1])===this.robot).map(e=>J(e[2])).filter(e=>e!==this.me)}get asking(){return this.#i.some(t=>J(t[1])===this.robot&&J(t[2])===this.me)}#l(){let t=this.#s,e=this.#r,n=this.holder;this.#s=n,this.#r=n!==""&&n===this.me,t!==n&&(this.#r?this.change=t?{from:t,to:n}:null:e&&!this.#o&&(this.change={from:t,to:n}),this.#o=!1)}setLive(t){this.live!==t&&(this.live=t,this.changed())}onChange(t){this.#e.push(t),t(this.mine,this.holder)}changed(){let t=Rt("arm-chip");t.hidden=this.holder==="",t.textContent=this.mine?"arm: in your hands":`arm: ${this.live?this.holder:"not known"}`,t.className=this.mine?"chip good":"chip warn";for(let e of this.#e)e(this.mine,this.holder);this.#c()}async#c(){if(!this.live||!this.asking||this.#a||!(this.mine||this.holder===""))return;this.#a=!0;let t=this.mine?"ask-no-more":"command";await this.#t.hold(t,this.robot).catch(()=>{}),this.#a=!1,this.mine&&this.#c()}async toggle(){return this.mine?this.#u():this.holder===""?this.#t.hold("command",this.robot):await pl(`${this.holder} has the arm in hand. Take it over? Its motion ends.`)?this.#t.hold("take-over",this.robot):void 0}async#u(){this.#o=!0;try{await this.#t.hold("let-go",this.robot)}catch(t){throw this.#o=!1,t}}toggleWish(){return this.#t.hold(this.asking?"ask-no-more":"ask-for",this.robot)}};function Pi(i,t){let e=R("tbody",{}),n=s=>s instanceof HTMLTableCellElement?s:R("td",{},s instanceof Node?s:Jt(String(s)));return{panel:R("table",i,R("thead",{},R("tr",{},...t.map(s=>R("th",{},s)))),e),fill:s=>e.replaceChildren(...s.map(r=>R("tr",{},...r.map(n))))}}var sp=10,gl=560,rp=220,Xo={width:104,height:26},op=["QUERY","SEND","PUSH","EVENT","STREAM"],ap=15,_x=i=>i.length>ap?`${i.slice(0,ap-1)}\u2026`:i;function xx({components:i,connections:t}){let e=new Map(i.map(({name:o},a)=>{let l=2*Math.PI*a/i.length-Math.PI/2;return[o,{x:gl/2+(rp+10)*Math.cos(l),y:gl/2+rp*Math.sin(l)}]})),n=({from:o,to:a,pattern:l,about:c})=>{let[h,u]=[e.get(o),e.get(a)];if(!h||!u)return null;let f=Math.max(Math.hypot(u.x-h.x,u.y-h.y),1),[d,m]=[(u.x-h.x)/f,(u.y-h.y)/f],y=4+5*op.indexOf(l),p=Math.min(Xo.width/2/Math.max(Math.abs(d),.01),Xo.height/2/Math.max(Math.abs(m),.01))+4,g={x1:h.x+d*p+m*y,y1:h.y+m*p-d*y,x2:u.x-d*p+m*y,y2:u.y-m*p-d*y},v=Sn("title",{},`${o} ${l} ${a}: ${c.join(" ")}`);return Sn("line",{...g,class:`way ${l}`,"marker-end":`url(#end-${l})`},v)},s=op.map(o=>Sn("marker",{id:`end-${o}`,markerWidth:7,markerHeight:7,refX:6,refY:3,orient:"auto"},Sn("path",{d:"M0,0 L6,3 L0,6 z",class:o}))),r=[...e].flatMap(([o,{x:a,y:l}])=>[Sn("rect",{x:a-Xo.width/2,y:l-Xo.height/2,...Xo,rx:5,class:"component"}),Sn("text",{x:a,y:l+4,"text-anchor":"middle"},_x(o))]);return Sn("svg",{class:"graph",viewBox:`0 0 ${gl} ${gl}`,role:"img","aria-label":`${i.length} components and ${t.length} connections`},Sn("defs",{},...s),...t.map(n).filter(Boolean),...r)}var yx=[["physical","a device"],["performance","a reaction time"],["abstraction","a function"]];function vx({components:i,wrappers:t}){let e=new Map(t.map(n=>[n.component,n]));return i.map(n=>{let s=e.get(n.name),r=yx.filter(([a])=>n[a]).map(([,a])=>a),o=(s?.abstraction??[]).map(a=>`${a.wrapped} ${a.operations}/${a.functions} = ${a.i_abstract.toFixed(3)}`);return[n.name,r.join(", ")||"none told",s?.offered??0,o.join("; ")||"\u2013",(s?.parts??[]).join(" ")]})}function Sx({connections:i}){return i.map(t=>[`${t.from} \u2192 ${t.to}`,t.pattern,t.count,t.p50_ms?`${t.p50_ms.toFixed(1)} / ${t.p99_ms.toFixed(1)}`:"\u2013",t.about.join(" "),t.remark||(t.recommended===t.pattern?"as the tables have it":t.recommended)])}function _l(i,...t){return R("section",{"aria-label":i},R("h2",{},i),...t)}function gu(i,t,e){let n=Pi({id:i},t);return n.fill(e),R("div",{class:"scroll",tabindex:0,role:"group","aria-label":t[0]},n.panel)}function Mx(i){let{i_cpx:t,i_struct:e,i_cnx:n}=i,s=i.scales.map(({subscribers:r,p50_ms:o})=>`${r}: ${o.toFixed(2)} ms`).join(", ");return[_l("Divide",R("p",{id:"indices"},`I_cpx ${t.toFixed(3)}, I_struct ${e.toFixed(3)}, I_cnx ${n.toFixed(3)}`),xx(i),R("p",{class:"quiet"},"QUERY blue, SEND violet, PUSH green, EVENT orange, STREAM grey.")),_l("Wrap",gu("wrappers",["Component","Is one for","Operations","I_abstract","Parts of a wrapper"],vx(i))),_l("Connect",gu("connections",["Connection","Pattern","Times","ms p50 / p99","About","The tables say"],Sx(i))),_l("What is wrong",i.faults.length?gu("faults",["Fault","Of","Why"],i.faults.map(r=>[r.symbol,r.subject,r.sentence])):R("p",{},"no fault was found"),s&&R("p",{class:"quiet"},`A fact reaches so many readers: ${s}.`))]}function lp(i){let t=R("span",{class:"quiet",role:"status",id:"method-note"}),e=R("div",{id:"method"}),n=R("button",{type:"button",id:"method-look"},`Look for ${sp} s`);return n.addEventListener("click",async()=>{n.disabled=!0,t.textContent="looking at who asks, answers, tells and watches \u2026";try{let s=await i.method(sp);e.replaceChildren(...Mx(s).filter(Boolean)),t.textContent=`seen for ${s.seconds} s`}catch(s){t.textContent=Te(s)}n.disabled=!1}),R("details",{class:"goals"},R("summary",{},"The method: Divide, Wrap, Connect"),R("div",{class:"row"},n,t),e)}function cp(i,t){let e=Pi({id:"processes"},["Process","Host","Restarts","The last of it"]),n=R("span",{class:"quiet"},"0"),s=new Map;return i.follow("(process ?host ?name ?running ?restarts ?newest)",o=>{let a=o.map(dt).sort((l,c)=>J(l[2]).localeCompare(J(c[2])));s.clear();for(let[,,l,,c]of a)s.set(J(l),c);n.textContent=String(a.length),e.fill(a.map(([,l,c,h,u,f])=>[J(c),J(l),u,J(h)==="yes"?J(f):R("span",{class:"chip bad"},J(f))])),t()}),{panel:R("details",{class:"goals"},R("summary",{},"Processes and their restarts ",n),e.panel),restarts:s}}var hp=50;function up(i,t){let e=R("span",{class:"quiet",id:"refusal-count"},"0"),n=Pi({id:"refusals"},["Client","Refused","Times","The newest"]),s=Pi({id:"clients"},["Client","Requests/s"]);i.follow("(board-refusal ?client ?symbol ?count ?sentence)",o=>{let a=o.map(dt).sort((l,c)=>c[3]-l[3]);e.textContent=String(a.length),n.fill(a.slice(0,hp).map(([,l,c,h,u])=>[J(l),J(c),h,J(u)]))});let r=R("details",{class:"goals"},R("summary",{},"Refused by the board ",e),n.panel,s.panel);return t.shownIn(r,o=>s.fill((o?.clients??[]).slice(0,hp).map(a=>[a.name||"(no hello)",a.requests_per_second]))),r}var bx={wired:"","stands-in":"stands in",absent:"is away"},wx=64;function fp(i){let t=R("tbody",{}),e=["Client","Role","Is played by",""].map(s=>R("th",{},s));i.follow("(holder ?client ?role ?server ?state)",s=>{let r=s.map(o=>dt(o).slice(1).map(J)).sort();t.replaceChildren(...r.slice(0,wx).map(([o,a,l,c])=>R("tr",{class:c==="wired"?"":"warn"},...[o,a,l,bx[c]??c].map(h=>R("td",{},Jt(h,64))))))});let n=R("table",{id:"served"},R("thead",{},R("tr",{},...e)),t);return R("details",{class:"goals",open:!0},R("summary",{},"Who serves whom"),n)}function Tx(i,t){let e=i?`${i.told_per_second.toFixed(1)} told/s, ${i.waiting} waiting, ${i.queued} queued`:"",n=t===void 0?"":`${t} restart${t===1?"":"s"}`;return[e,n].filter(Boolean).join(", ")}function dp(i,t){let e=R("div",{class:"timeline"}),n=new Map,s=new Map,r=[],o=new Map,a=h=>{if(s.has(h))return s.get(h);let u=R("span",{class:"quiet"}),f=R("span",{class:"quiet load"}),d=R("pre",{}),m=R("details",{"data-agent":h},R("summary",{},R("strong",{},Jt(h,64)),u,f),d);return s.set(h,{made:m,who:u,does:f,offers:d}),s.get(h)},l=()=>{let h=r.slice(0,64).map(u=>{let f=J(u[1]),{who:d,does:m,offers:y}=a(f);d.textContent=`${J(u[2])} on ${Jt(J(u[3]),64)}`,m.textContent=Tx(o.get(f),c.restarts.get(f));let p=n.get(f);return y.textContent=p?Jt(p.map(we).join(`
`),6e3):"it told no contract",f});for(let u of s.keys())h.includes(u)||s.delete(u);e.replaceChildren(...h.map(u=>s.get(u).made))},c=cp(i,()=>l());Rt("agents").append(e,c.panel,up(i,t),fp(i),lp(i)),t.shownIn(e,h=>{o=new Map((h?.agents??[]).map(u=>[u.name,u])),l()}),i.follow("(agent ?name ?kind ?host)",h=>{r=h.map(dt).sort((u,f)=>J(u[1]).localeCompare(J(f[1]))),l()}),i.follow("(contract ?name ?form)",h=>{n.clear();for(let[,u,f]of h.map(dt))n.set(J(u),f.filter(Array.isArray));l()})}var Ex=5e3,mp=["Cell","Agents","Goal","Arms","Stopped by","Last word"],pp=i=>i&&R("span",{class:"chip bad"},i);function Ax({path:i,console:t,leads:e}){let n=i||"this one",s=t.startsWith("https://");return R("td",{},s?R("a",{href:t,target:"_blank",rel:"noopener noreferrer"},n):n,e&&R("small",{class:"quiet"},`${e} leads`))}function Cx(i){let t=Ax(i);return i.fault?[t,R("td",{colspan:mp.length-1},pp(i.fault))]:[t,i.agents,i.goal,i.arms,pp(i.stops),i.said]}function Rx(i,t){let e=document.activeElement,n=e instanceof HTMLAnchorElement&&i.panel.contains(e)&&e.href;i.fill(t),n&&[...i.panel.querySelectorAll("a")].find(s=>s.href===n)?.focus()}function gp(i){let t=Pi({id:"cells-table"},mp),e=R("p",{class:"quiet",role:"status"},"looking \u2026"),n=Rt("cells");n.append(t.panel,e);let s=!1,r=!1,o=0,a=async()=>{if(clearTimeout(o),!(r||!s)){r=!0;try{let l=await i.cells();Rx(t,l.cells.map(Cx)),e.textContent=l.more?`More than these ${l.cells.length} are named: ./pizarra cells lists all`:""}catch(l){e.textContent=Te(l)}r=!1,o=setTimeout(a,Ex)}};new IntersectionObserver(l=>{s=l[l.length-1].isIntersecting,a()}).observe(n),i.follow("(context-board ?name ?address)",l=>{l.length>0&&(Rt("tab-cells").hidden=!1)})}var Px=60,Br=class{#t;#e;#n;list;constructor(t,e,n,s){this.#t=t,this.#e=e,this.#n=n,this.list=R("ol",{class:"log","aria-label":s}),t.followAlways("(request ?id ?agent ?operation)",(r,o)=>this.#s(o.added))}#i(t,e){let n=R("span",{}),s=R("li",{},R("time",{},tn(Date.now()*1e3)),R("span",{class:"quiet"},`${Jt(t,40)} `),R("code",{},Jt(e,200)),n);for(this.list.prepend(s);this.list.children.length>Px;)this.list.lastChild?.remove();return{item:s,answer:n}}#s(t){for(let e of t){let{teller:n}=e.facts[0],[,,s,r]=dt(e);J(s)===this.#e()&&n!==this.#n()&&this.#i(n,we(r))}}async follow(t,e){let{item:n,answer:s}=this.#i("you",t);s.textContent=" \u2026";try{s.textContent=` ${Jt((await e).join(" ")||"ok",200)}`}catch(r){s.textContent=` ${Te(r)}`,n.className="bad"}}send(t){return this.follow(t,this.#t.request(this.#e(),ni(t)))}};var Ix=50,Lx=[["left","\u25C0","Left"],["up","\u25B2","Up"],["out","\u21E7","Out"],["turn-left","\u27F2","Turn left"],["tool-up","\u2912","Tool up"],["wrist-left","\u21BA","Wrist left"],["right","\u25B6","Right"],["down","\u25BC","Down"],["in","\u21E9","In"],["turn-right","\u27F3","Turn right"],["tool-down","\u2913","Tool down"],["wrist-right","\u21BB","Wrist right"]],_u=class{#t;#e;#n;#i;#s=null;#r=null;constructor(t,e,n){this.#t=t,this.#e=e,this.#n=n,e.onChange(s=>s||this.end()),window.addEventListener("blur",()=>this.end()),window.addEventListener("pagehide",()=>this.end()),document.addEventListener("visibilitychange",()=>{document.hidden&&this.end()})}begin(t,e){if(this.#s||!this.#e.mine)return;let n={button:e};this.#s=n,e.classList.add("held");let s=()=>this.#s===n&&this.#o(t,n);this.#r?this.#r.then(s):s()}#o(t,e){let n=this.#t.jog(this.#e.robot,t);this.#n.follow(`(jog ${t})`,n),this.#i=setInterval(()=>this.#t.holdOn(),Ix);let s=()=>{this.#r=null,this.#s===e&&this.end()};this.#r=n.then(s,s)}end(){this.#s&&(clearInterval(this.#i),this.#t.release(),this.#s.button.classList.remove("held"),this.#s=null)}};function Dx(i,[t,e,n]){let s=R("button",{type:"button",class:"jog","data-jog":t,"aria-label":`Jog: ${n}`,title:n},R("span",{"aria-hidden":"true"},e),R("small",{"aria-hidden":"true"},n));s.addEventListener("pointerdown",r=>{r.button===0&&(s.setPointerCapture(r.pointerId),i.begin(t,s))});for(let r of["pointerup","pointercancel","lostpointercapture","blur"])s.addEventListener(r,()=>i.end());return s.addEventListener("contextmenu",r=>r.preventDefault()),s.addEventListener("keydown",r=>{r.key==="Escape"&&i.end(),!(r.key!==" "&&r.key!=="Enter")&&(r.preventDefault(),r.repeat||i.begin(t,s))}),s.addEventListener("keyup",r=>{(r.key===" "||r.key==="Enter")&&i.end()}),s}function _p(i,t,e){let n=new _u(i,t,e),s=Lx.map(a=>Dx(n,a)),r=R("p",{class:"quiet",id:"jog-note"},"");return i.onPulse=({deadline:a,rtt:l})=>{let c=l<0?"not measured yet":`${l.toFixed(0)} ms there and back`;r.textContent=`Hold to move. Line: ${c}; silence of ${a.toFixed(0)} ms stops the arm, within 10 mm.`},t.onChange(()=>{t.live||(r.textContent=`${t.why}: nothing moves.`)}),{parts:[R("div",{class:"jogs",role:"group","aria-label":"Jog: hold to move"},...s),r],buttons:s}}var Nx=/^(Arrow\w+|Page\w+|Home|End)$/;function xp(i,t,e){let n=R("output",{},""),s=R("input",{type:"range","aria-label":i,...e}),r=()=>{n.textContent=`${s.value} ${t}`,s.setAttribute("aria-valuetext",n.textContent)};return s.addEventListener("input",r),r(),{row:R("label",{class:"slide"},R("span",{},i),s,n),input:s,show:r}}function yp(i,{letGo:t,drop:e}){let n="";i.addEventListener("pointerdown",()=>n="pointer"),i.addEventListener("keydown",r=>{Nx.test(r.key)&&(n="key")});let s=()=>{n="",t()};i.addEventListener("change",()=>n!=="key"&&s()),i.addEventListener("keyup",()=>n==="key"&&s()),i.addEventListener("pointerup",()=>n="");for(let r of["pointercancel","blur"])i.addEventListener(r,()=>{n="",e()});return()=>n!==""}function xl({label:i,unit:t,most:e,form:n},s){let{row:r,input:o,show:a}=xp(i,t,{min:-e,max:e,step:1,value:0}),l=()=>{let h=Number(o.value);return o.value="0",a(),h};return yp(o,{letGo:()=>{let h=l();h!==0&&s(n(h))},drop:l}),o.addEventListener("keydown",h=>h.key==="Escape"&&l()),{row:r,input:o}}function qo({label:i,unit:t,least:e,most:n,value:s,form:r},o){let{row:a,input:l,show:c}=xp(i,t,{min:e,max:n,step:1,value:s}),h=s,u=()=>{l.value=String(h),c()},f=yp(l,{letGo:()=>o(r(Number(l.value))),drop:u});return{row:a,input:l,put:m=>{h=m,f()||u()}}}var $o=(i,t,e)=>n=>`(${i} ${n>0?t:e} ${Math.abs(n)})`,Ux=[{label:"Retract / extend",unit:"mm",most:100,form:i=>i>0?`(extend keep-height ${i})`:`(retract ${-i})`},{label:"Turn left / right",unit:"\xB0",most:45,form:$o("turn","right","left")},{label:"Move left / right",unit:"mm",most:100,form:$o("move-h","right","left")},{label:"Move down / up",unit:"mm",most:100,form:$o("move-v","up","down")},{label:"Tool down / up",unit:"\xB0",most:45,form:$o("turn-ef","up","down")},{label:"Wrist left / right",unit:"\xB0",most:90,form:$o("turn-wrist","right","left")}],Fx={label:"Gripper",unit:"mm",least:0,most:100,value:80,form:i=>`(gripper ${i})`},Ox={label:"Speed",unit:"%",least:1,most:100,value:50,form:i=>`(speed ${i})`};function Bx(i,t){let e=R("output",{class:"axes","aria-label":"Axis positions"},"no arm has told its joints yet");return i.follow("(arm-joints ?robot ?joints)",n=>{let s=n.map(dt).find(r=>J(r[1])===t.robot);s&&(e.textContent=s[2].map((r,o)=>`j${o+1} ${r.toFixed(1)}`).join("   "))}),e}function kx(i,t,e){let n=R("datalist",{id:"variables"}),s=R("input",{id:"variable",list:"variables",maxlength:32,size:12,spellcheck:"false",placeholder:"p1","aria-label":"Name of a place",pattern:"[a-z][a-z0-9\\-]*",title:"a letter, then letters, digits and hyphens"}),r=l=>()=>s.value&&s.reportValidity()&&e.send(`(${l} ${s.value})`),o=R("button",{type:"button",onclick:r("learn")},"Save"),a=R("button",{type:"button",onclick:r("goto")},"Go to");return i.follow("(robot-variable ?robot ?name ?joints)",l=>{let c=l.map(dt).filter(h=>J(h[1])===t.robot);n.replaceChildren(...c.map(h=>R("option",{value:J(h[2])})))}),{parts:[s,n,o,a],name:s,save:o,go:a}}function zx(i){let t=R("input",{id:"action",maxlength:4e3,spellcheck:"false",placeholder:"(move 350 0 300)   or   CIRCLE p1, p2, p3","aria-label":"Action"}),e=R("button",{type:"submit"},"Do action"),n=R("form",{class:"row"},t,e);return n.addEventListener("submit",s=>{s.preventDefault(),t.value&&i.send(we([Wt("do-action"),t.value]))}),{form:n,controls:[t,e]}}function Vx(i,t,e){let n=R("span",{id:"service-light",class:"chip",role:"status"}),s=new Set,r=new Map,o=()=>s.has(t.robot)?r.has(t.robot)?`${r.get(t.robot)} released control: get it first`:"":"No robot is present",a=()=>{n.textContent=o()||"In service",n.className=`chip ${o()?"bad":"good"}`,e()};return i.followAlways("(agent ?name robot ?host)",l=>{s=new Set(l.map(c=>J(dt(c)[1]))),a()}),i.followAlways("(robot-released ?robot ?client)",l=>{r=new Map(l.map(c=>[J(dt(c)[1]),J(dt(c)[2])])),a()}),t.onChange(a),{light:n,why:o}}function Gx(i,t,e,n){for(let s of t)s.dataset.title=s.title;return()=>{for(let s of t){let r=i.why||(e.has(s)?n():"");s.disabled=r!=="",s.title=r||(s.dataset.title??"")}}}function Hx(i){let t=R("span",{class:"quiet"}),e=R("button",{type:"button",id:"take-arm",class:"strong"},"Take the arm in hand");e.addEventListener("click",()=>i.toggle().catch(s=>t.textContent=Te(s)));let n=R("button",{type:"button",id:"ask-for-arm",hidden:!0},"Ask for it");return n.addEventListener("click",()=>i.toggleWish().catch(s=>t.textContent=Te(s))),i.onChange((s,r)=>{if(e.disabled=!i.live,!i.live){t.textContent=`${i.why}.`;return}n.hidden=s||r==="",n.textContent=i.asking?"Ask no more":"Ask for it",e.textContent=s?"Let the arm go":r?`Take over from ${r}`:"Take the arm in hand",t.textContent=s?"Only you move the arm now.":r?i.asking?`${r} is asked for it.`:"":"Anybody may move the arm: a goal, a prompt."}),R("div",{class:"row"},e,n,t)}function vp(i,t){let e=new Br(i,()=>t.robot,()=>t.me,"Commands that the arm received, newest first"),n=C=>e.send(C),s=(C,S)=>R("button",{type:"button",onclick:()=>n(S)},C),r=[s("Home","(home)"),s("Ready","(ready)")],o=[s("Get control","(get-control)"),s("Release control","(release-control)")],a=[s("Monitor","(monitor)"),s("Finish: report","(finish report)"),s("Finish: stop","(finish stop)"),s("Status","(get-status)")],l=_p(i,t,e),c=Ux.map(C=>xl(C,n)),h=qo(Fx,n),u=qo(Ox,n),f=kx(i,t,e),d=zx(e),m=[...r,...l.buttons,...[...c,h].map(C=>C.input),f.go,...d.controls],y=[...o,u.input,f.name,f.save],p=()=>{},{light:g,why:v}=Vx(i,t,()=>p());p=Gx(t,[...m,...y],new Set(m),v),Rt("drive").append(Hx(t),R("div",{class:"row"},g,...o,...r),R("div",{class:"row"},...a),R("div",{class:"driving"},R("div",{},...l.parts),R("div",{class:"slides"},...c.map(C=>C.row),h.row,u.row)),R("div",{class:"row"},...f.parts,Bx(i,t)),d.form,R("h2",{},"Commands received"),e.list),p(),i.follow("(robot-speed ?robot ?percent)",C=>{let S=C.map(dt).find(P=>J(P[1])===t.robot);S&&u.put(S[2])}),i.follow("(gripper ?robot ?opening)",C=>{let S=C.map(dt).find(P=>J(P[1])===t.robot);S&&h.put(Math.round(S[2]))})}var yl=class{#t;#e=new Map;#n=[];constructor(t){this.#t=t,t.followAlways("(holder console ?role ?server ?state)",e=>{let n=e.map(dt).filter(([,,,,s])=>J(s)!=="absent");this.#e=new Map(n.map(([,,s,r])=>[J(s),J(r)]));for(let s of this.#n)s()})}server(t){return this.#e.get(t)??""}follow(t,e,n){let s=[],r=()=>{let o=this.server(t);n(o===""?s:s.filter(a=>J(a[1])===o))};this.#t.follow(e,o=>{s=o.map(dt),r()}),this.onChange(r)}onChange(t){this.#n.push(t)}};var Wx={looking:"looking for boards",fitting:"fitting",done:"done",failed:"failed"},Xx={done:"good",failed:"bad"},kr=3,qx=64,$x=32,Yx=8192,vl={missing:"#4b3a17",grid:"#2a3b47",taken:"#7fd18b",now:"#f2a33a"};function Sp(i,t,e,n){let s=Ki(i);s.strokeStyle=e,s.lineWidth=n,s.beginPath();for(let r=0;r+1<t.length;r+=2)s.lineTo(t[r],t[r+1]);s.closePath(),s.stroke()}function Zx(i,t){let e=Ki(i),[n,s]=[i.width/kr,i.height/kr];e.clearRect(0,0,i.width,i.height),e.fillStyle=vl.missing;for(let[,r,o]of t)e.fillRect(r*n,o*s,n,s);e.strokeStyle=vl.grid,e.lineWidth=1;for(let r=0;r<kr*kr;++r)e.strokeRect(r%kr*n,Math.floor(r/kr)*s,n,s)}function Mp(){let i=R("canvas",{role:"img"}),t=R("small",{});return{canvas:i,label:t,box:R("div",{class:"boards"},i,t)}}function bp(i){let t=R("span",{class:"chip",id:"calibration-state",role:"status"}),e=R("span",{id:"calibration-count"}),n=R("p",{id:"calibration-sentence",hidden:!0}),s=R("span",{class:"quiet",id:"calibration-sees"}),r=R("ul",{id:"calibration-lacks","aria-label":"Still missing"}),o=[Mp(),Mp()],a=R("section",{id:"calibration","aria-label":"Calibration",hidden:!0},R("div",{class:"row"},R("h2",{},"Calibration"),t,e,s),n,R("div",{class:"calibrating"},...o.map(d=>d.box),r)),l,c=[],h=[],u=[],f=()=>{if(a.hidden=l===void 0,l===void 0)return;let[,d,m,y,p,g,v]=l,C=J(d);t.textContent=Wx[C]??C,t.className=`chip ${Xx[C]??"busy"}`,e.textContent=`${g} of ${v} boards`,n.textContent=Jt(J(m),1e3),n.hidden=n.textContent==="";let S=u.map(([,E])=>Jt(J(E)));r.replaceChildren(...(S.length?S:["nothing more"]).map(E=>R("li",{},E)));let P=c.some(E=>1 in E);o.forEach(({canvas:E,label:_,box:b},O)=>{let D=[y,p].every(A=>A>0&&A<=Yx);if(b.hidden=!D||!c.some(A=>O in A),!b.hidden){_.textContent=`Boards in the ${P?["left ","right "][O]:""}image`,E.setAttribute("aria-label",_.textContent),Object.assign(E,{width:y,height:p}),Zx(E,u.map(([,,A])=>A).filter(([A])=>A===O));for(let A of c)O in A&&Sp(E,A[O],vl.taken,2);O in h&&Sp(E,h[O],vl.now,4)}})};return i.follow("(calibration ?state ?sentence ?width ?height ?boards ?wanted)",d=>{l=d.length?dt(d[0]):void 0,f()}),i.follow("(calibration-board ?number ?outlines)",d=>{c=d.slice(0,qx).map(m=>dt(m)[2]),f()}),i.follow("(calibration-sees ?outlines ?sentence)",d=>{h=d.length?dt(d[0])[1]:[],s.textContent=d.length?`the newest image: ${Jt(J(dt(d[0])[2]))}`:"",f()}),i.follow("(calibration-lacks ?sentence ?part)",d=>{u=d.slice(0,$x).map(dt),f()}),a}var sr="end-effector",Jx=["Area","Perimeter","NF","M0","M1","M2"],Sl=class{#t=[];#e=new Map;#n=[];#i=[];constructor(t){let e=(n,s)=>t.follow("eyes",n,r=>{s(r),this.#s()});e("(learned ?eyes ?name ?num ?area ?perimeter ?nf ?m0 ?m1 ?m2)",n=>this.#t=n),e("(learned-template ?eyes ?name ?num ?tone ? ? ? ? ? ? ?picture)",n=>{this.#e=new Map(n.map(s=>[`${s[1]} ${s[2]} ${s[3]}`,s]))}),e("(look-alike ?eyes ?name ?other ?error ?sentence)",n=>this.#n=n)}onChange(t){this.#i.push(t)}#s(){for(let t of this.#i)t()}names(){let t=[...new Set(this.#t.map(e=>J(e[2])))].sort();return t.includes(sr)?[sr,...t.filter(e=>e!==sr)]:t}samples(t){return this.#t.filter(e=>J(e[2])===t).map(e=>this.#r(e))}newest(t){return this.samples(t).toSorted((e,n)=>n.num-e.num)[0]}alike(t){return this.#n.filter(e=>[J(e[2]),J(e[3])].includes(t)).map(e=>J(e[5]))}#r(t){let e=this.#e.get(`${t[1]} ${t[2]} ${t[3]}`),n=t.slice(4).map((s,r)=>[Jx[r],s.toFixed(Number.isInteger(s)?0:3)]);return{eyes:J(t[1]),num:t[3],parameters:n,picture:e?J(e.at(-1)):"",tone:e?J(e[4]):"dark"}}};var zr=32;function Ml(i,t,e){let n=R("canvas",{class:"template",width:zr,height:zr,role:"img","aria-label":e});if(!/^[0-9a-f]{1024}$/.test(i))return n;let s=Ki(n),r=s.createImageData(zr,zr);for(let o=0;o<zr*zr;++o){let a=parseInt(i[o],16)/15,l=Math.round(255*(t==="light"?a:1-a));r.data.set([l,l,l,255],4*o)}return s.putImageData(r,0,0),n}var Kx=[sr,"circle","triangle","square","cross"],jx=i=>/^\(LEARN ".*" OK\)$/.test(i[0]??""),bl=class{#t;#e;#n;#i;#s=!1;#r=null;panel=R("div",{class:"teaching"});training=R("button",{type:"button",id:"training","aria-pressed":"false"},"Training: off");#o=R("p",{class:"quiet",id:"teach-hint",role:"status"});#a=R("input",{id:"learn-name",list:"learned-names",maxlength:64,spellcheck:"false",placeholder:"a name, or none yet",pattern:"[A-Za-z][A-Za-z0-9\\-]*",title:"a letter, then letters, digits and hyphens"});#l=R("datalist",{id:"learned-names"});#c=R("div",{class:"learned-sample"});#u=R("div",{class:"learned-window",id:"learned-window",role:"group",hidden:!0});constructor({ask:t,objects:e,provisional:n,why:s}){this.#t=t,this.#e=e,this.#n=n,this.#i=s,this.training.addEventListener("click",()=>this.#d(!this.#f)),this.panel.append(R("div",{class:"row"},this.training,R("label",{for:"learn-name"},"Name"),this.#a),this.#l,this.#o,this.#u),e.onChange(()=>{this.#p(),this.#s||this.#m()}),this.#p()}get#f(){return this.training.getAttribute("aria-pressed")==="true"}#d(t){this.training.setAttribute("aria-pressed",String(t)),this.training.textContent=`Training: ${t?"on":"off"}`,document.body.classList.toggle("training",t),this.#p()}#h(t){this.#o.textContent=t}#p(){let t=this.#e.names().filter(n=>n!==this.#n());if(this.#l.replaceChildren(...t.map(n=>R("option",{value:n}))),this.#s)return;let e=t.includes(sr)?"":" Begin with the end-effector: the triangle on the gripper.";this.#h(this.#f?`Click on a mark in the camera\u2019s image.${e}`:"Switch training on, and click on a mark."),this.#f&&e&&this.#a.value===""&&(this.#a.value=sr)}more(t){this.#d(!0),this.#a.value=t}take(t){return this.#f?(this.#s||!this.#a.reportValidity()||this.#_(t,this.#a.value||this.#n()),!0):!1}#g(t){return this.#e.newest(t)?.num??0}async#_(t,e){this.#s=!0,this.#u.hidden=!0,this.#h(`Learning what is at ${t.x}, ${t.y} of frame ${t.frame}: red while it is filled, then its border.`);let n=this.#g(e);try{let s=await this.#t(Wt("learn"),t.x,t.y,t.frame,e);if(!jx(s))throw{said:`${s[0]??"FAIL"}: ${await this.#i(s[0]??"")}`};this.#r={name:e,before:n},this.#x(e)}catch(s){this.#h(`${Te(s)}. For one more sample of an object write its name first; then click again.`)}this.#s=!1}#x(t){let e=t===this.#n(),n=R("input",{id:"new-name",required:!0,maxlength:64,spellcheck:"false",pattern:"[A-Za-z][A-Za-z0-9\\-]*",title:"a letter, then letters, digits and hyphens",value:e?"":t}),s=this.#e.names(),r=l=>R("button",{type:"button",class:"small",onclick:()=>n.value=l},l),o=e?Kx.filter(l=>!s.includes(l)).map(r):[],a=R("form",{class:"row"},R("label",{for:"new-name"},"Name it"),n,...o,R("button",{type:"submit",class:"strong"},"Accept"),R("button",{type:"button",id:"reject",onclick:()=>this.#S()},"Reject"));a.addEventListener("submit",l=>{l.preventDefault(),this.#v(n.value)}),this.#u.replaceChildren(this.#c,a),this.#m(),this.#u.hidden=!1,this.#h("Learned. Accept it under a name, or reject it."),n.focus()}#m(){let{name:t,before:e}=this.#r??{name:"",before:0},n=this.#e.newest(t);if(!n||n.num<=e)return this.#c.replaceChildren();let r=[["Name",t===this.#n()?"to be named":t],...n.parameters,["Num",String(n.num)]];this.#c.replaceChildren(Ml(n.picture,n.tone,`What was learned as ${t}`),R("dl",{class:"parameters"},...r.flatMap(([o,a])=>[R("dt",{},o),R("dd",{},a)])),...this.#e.alike(t).map(o=>R("p",{class:"warn"},Jt(o))))}async#y(t,e,n){let s=this.#r;if(this.#s||!s)return;this.#s=!0,this.#h(t);let r=n;try{await e(s.name),this.#r=null,this.#u.hidden=!0,this.#a.value=""}catch(o){r=Te(o)}this.#s=!1,this.#p(),this.#h(r)}#v(t){let e=async n=>{t!==n&&await this.#t(Wt("rename"),n,t),this.#r={name:t,before:0},await this.#t(Wt("accept"),t)};return this.#y(`Accepting ${t} \u2026`,e,`${t} is accepted. Click on the next mark.`)}#S(){return this.#y("Rejecting \u2026",t=>this.#t(Wt("reject"),t),"Rejected: nothing was learned.")}};function Qx(i,t,e){let n="no eyes are present";if(!i)return{train:n,forget:n,track:n,end:n};let s=c=>t.filter(([,h])=>h===c).map(([h])=>h),r=s("tracking"),o=s("learning"),a=r.length?`${r.join(", ")} tracks, which excludes learning: end that first`:"",l=o.length?`${o[0]} is learning`:"";return{train:a||(o.includes(e)?"":l),forget:a||l,track:l,end:r.includes(e)?"":r.length?`${r[0]} tracks, and ends it itself`:"nothing is tracked"}}var ty=([,,,i,,t])=>J(i)==="lost"?"lost":`${J(i)}, ${(t*100).toFixed(0)} %`;function rr(i,t){i.disabled=t!=="",i.title=t}function wp(i,t,e,n){let s=Rt("eyes"),r=R("pre",{class:"answer",id:"eyes-answer",role:"status",hidden:!0}),o=R("span",{id:"eyes-mode",class:"chip"},"no eyes"),a=R("span",{class:"quiet"}),l=R("pre",{class:"answer","aria-label":"What TRACK says",hidden:!0}),c=new Sl(e),h="vision",u=!1,f=[],d=(...A)=>i.request(h,A),m=async A=>{let F=await i.ask([Wt("vision-failed"),Wt(h),Wt("?"),A,Wt("?"),Wt("?sentence")]);return F.length?J(dt(F[0])[5]):"no reason was told"},y=async(...A)=>{r.hidden=!1,r.textContent="\u2026";try{let F=await d(...A),G=/ FAIL\)/.test(F[0]??"")?`
${await m(F[0])}`:"";r.textContent=Jt((F.join(`
`)||"ok")+G,2e3)}catch(F){r.textContent=Te(F)}},p=(A,...F)=>R("button",{type:"button",onclick:()=>y(...F)},A),g=p("Connect",Wt("connect")),v=p("Disconnect",Wt("disconnect")),C=p("End track",Wt("end-track")),S=new bl({ask:d,objects:c,provisional:()=>`unnamed-${n().replace(/\D+/g,"-").replace(/^-/,"")}`,why:m});t.onPoint(A=>S.take(A));let P=R("ul",{class:"objects","aria-label":"Learned objects"});s.append(bp(i),R("div",{class:"row"},o,a),R("div",{class:"row"},g,v,C),S.panel,r,l,P);let E=new Map,_=new Map,b=()=>{for(let[A,{state:F}]of _){let G=E.get(A);F.textContent=G?ty(G):"not tracked"}},O=A=>{let F=c.samples(A),G=JSON.stringify([F,c.alike(A)]);if(_.get(A)?.of===G)return _.get(A);let N=R("span",{}),V=p("Track",Wt("track"),A),$=p("Forget",Wt("forget"),A),H=R("button",{type:"button",onclick:()=>S.more(A)},"Add sample"),ct=[...new Set(F.map(nt=>nt.eyes))].join(", "),K=c.alike(A).map(nt=>R("small",{class:"warn"},Jt(nt,160))),tt=R("li",{},R("span",{class:"templates"},...F.map(nt=>Ml(nt.picture,nt.tone,`Sample ${nt.num} of ${Jt(A,64)}`))),R("span",{},R("strong",{},Jt(A,64)),R("span",{class:"quiet"},` ${F.length} sample${F.length>1?"s":""} by ${Jt(ct,64)}; `,N),...K),p("Find",Wt("find"),A),V,H,$);return _.set(A,{of:G,item:tt,state:N,more:H,track:V,forget:$}),_.get(A)},D=()=>{let A=Qx(u,f,n()),F=f.some(([V,$])=>V===n()&&$==="connected");rr(g,u?F?"you are connected":"":"no eyes are present"),rr(v,F?"":"you are not connected"),rr(C,A.end),rr(S.training,A.train),a.textContent=f.map(([V,$])=>`${V}: ${$}`).join(", ");let G=c.names().slice(0,64);for(let V of _.keys())G.includes(V)||_.delete(V);let N=G.map(O);for(let{more:V,track:$,forget:H}of N)rr(V,A.train),rr($,A.track),rr(H,A.forget);dl(P,N.map(({item:V})=>V)),b()};c.onChange(D),e.follow("eyes","(vision-mode ?eyes ?mode ?connected)",([A])=>{u=!!A,h=A?J(A[1]):h;let F=A?J(A[2]):"no eyes";o.textContent=A?`${h}: ${F}`:F,o.className=`chip ${u?F==="idle"?"":"busy":"bad"}`,document.body.dataset.eyes=F,D()}),e.follow("eyes","(vision-held ?eyes ?client ?mode)",A=>{f=A.map(F=>[J(F[2]),J(F[3])]),D()}),e.follow("eyes","(tracked ?eyes ?name ?state ?frame ?confidence)",A=>{E.clear();for(let F of A)E.set(J(F[2]),F);b()}),e.follow("eyes","(look ?eyes ?frame ?text ?of)",([A])=>{l.hidden=!A,A&&(l.textContent=Jt(J(A[3]),1e3))})}var ey=4,ny=60,iy=i=>dt(i)[2].filter(t=>Array.isArray(t)&&J(t[0])==="posts").flatMap(t=>t.slice(1)).filter(t=>Array.isArray(t?.[2]));async function sy(i){let t=await i.ask([Wt("contract"),Wt("?"),Wt("?form")]),e=new Map(t.flatMap(iy).map(([,s,r])=>[J(s),r.length])),n=new Map;for(let[s,r]of e){let o=await i.ask([Wt(s),...Array(r).fill(Wt("?"))]);for(let{ids:a,facts:l}of o)n.set(a[0],l[0])}return n}function ry(i,t){return t?R("span",{class:"fact"},R("code",{},Jt(t.text,120)),R("small",{class:"quiet"},`fact ${i}, by ${t.teller} at ${tn(t.when)}`)):R("span",{class:"fact gone"},`fact ${i}, which is not there any more`)}function Tp(i,t,e,n,s){n.push(i);let o=(t&&s<ey?t.because:[]).slice(0,Math.max(0,ny-n.length)).map(l=>Tp(l,e.get(l),e,n,s+1)),a=o.length?R("ul",{"aria-label":"because of"},...o):null;return R("li",{},ry(i,t),a)}async function xu(i,t,e){let n=await sy(i);return R("ul",{class:"provenance","aria-label":"Because of what it was told"},Tp(t,e,n,[],0))}function Ep(i,t,e){if(e.because.length===0)return null;let n=R("div",{}),s=`Because of ${e.because.length} fact${e.because.length>1?"s":""}`,r=R("button",{type:"button",class:"because"},s);return r.addEventListener("click",async()=>{r.disabled=!0,n.replaceChildren(await xu(i,t,e)),r.disabled=!1}),R("div",{},r,n)}var Vr=(i,{teller:t,when:e})=>`fact ${i}, told by ${t} at ${tn(e)}`;var oy=60,ay=["Relation","Facts","Told/s","Watches","To board","To watcher","Told by"],Ap=i=>i?`${i.p50} / ${i.p99}`:"\u2013";function ly({revision:i,facts:t,transactions_per_second:e,journey:n}){let s=n?`; a fact is committed after ${n.committed_us} \xB5s, acknowledged after ${n.acknowledged_us} \xB5s, delivered after ${n.delivered_us} \xB5s`:"";return`revision ${i}, ${t} facts, ${e.toFixed(1)} transactions/s${s}`}function Cp(i,t,e){let n=R("p",{class:"quiet",id:"activity-note"},"\u2026"),s=Pi({id:"relations"},ay),r=new Map,o=c=>(r.has(c)||r.set(c,R("button",{type:"button",class:"small",onclick:()=>e(c)},c)),r.get(c).disabled=!t(c),r.get(c)),a=(c,h)=>{if(!c){n.textContent=h??"";return}n.textContent=ly(c);let u=c.relations.filter(f=>f.facts||f.told_per_second||f.watches).slice(0,oy);s.fill(u.toSorted((f,d)=>f.name.localeCompare(d.name)).map(f=>[o(f.name),f.facts,f.told_per_second.toFixed(1),f.watches,Ap(f.told_us),Ap(f.delivered_us),f.tellers.join(" ")]))},l=R("section",{"aria-label":"Relations"},R("h2",{},"Relations"),n,R("p",{class:"quiet"},"Under way to the board and from there, in \xB5s: the half / 99 %."),R("div",{class:"scroll",tabindex:0,role:"group","aria-label":"Table of relations"},s.panel));return i.shownIn(l,a),l}var wl=200,cy=i=>`(${J(i[1])}${i[2].map(t=>` ?${J(t[0])}`).join("")})`;function hy(i,t){if(i.length===0)return R("p",{class:"quiet"},"nothing, now");let e=Object.keys(i[0].bindings),n=R("tr",{},...(e.length?e:["fact"]).map(r=>R("th",{},r)),R("td",{})),s=i.slice(0,wl).map(r=>{let o=r.facts.map((l,c)=>Vr(r.ids[c],l)),a=e.length?e.map(l=>r.bindings[l]??""):[r.facts[0]?.text??"yes"];return R("tr",{title:o.join(`
`),class:t(r)?"new":""},...a.map(l=>R("td",{},Jt(l,160))),R("td",{},R("button",{type:"button",class:"because","data-ids":r.ids.join()},"Because \u2026")))});return R("table",{},R("thead",{},n),R("tbody",{},...s))}function Rp(i,t){let e=R("input",{id:"query",spellcheck:"false",list:"questions",placeholder:"(on ?x ?y)","aria-label":"Question"}),n=R("datalist",{id:"questions"}),s=R("span",{class:"quiet",id:"query-count"}),r=R("pre",{class:"answer bad",id:"query-wrong",hidden:!0}),o=R("div",{class:"scroll",id:"answers"}),a=R("form",{class:"row"},e,n,R("button",{type:"submit",class:"strong"},"Watch"),s),l=R("div",{id:"because",role:"group","aria-label":"Reasons",tabindex:0,hidden:!0}),c=new Map,h=Cp(t,m=>c.has(m),m=>{e.value=c.get(m)??"",a.requestSubmit()});Rt("facts").append(a,r,l,o,h);let u=[],f=async m=>{let p=(m.target instanceof Element?m.target.closest("button.because"):null)?.getAttribute("data-ids"),g=u.find(C=>C.ids.join()===p);if(!g)return;let v=g.facts.map((C,S)=>xu(i,g.ids[S],C));l.replaceChildren(...await Promise.all(v)),l.hidden=!1};o.addEventListener("pointerdown",f),o.addEventListener("keydown",m=>["Enter"," "].includes(m.key)&&f(m));let d=()=>{};a.addEventListener("submit",m=>{m.preventDefault(),d(),r.hidden=!0,s.textContent="",o.replaceChildren(),l.hidden=!0;let y=[],p=0,g=new Set,v=ii(()=>{let C=y.length+p>wl?`, ${wl} shown`:"";s.textContent=`${y.length+p} answer${y.length+p===1?"":"s"}${C}`,u=y;let S=g;g=new Set(y.slice(0,wl).map(P=>P.ids.join())),o.replaceChildren(hy(y,P=>S.size>0&&!S.has(P.ids.join())))});d=i.watch(e.value,(C,S)=>{y=C,p=S.resynchronised?S.cut:p+S.cut,v()},C=>{r.hidden=!1,r.textContent=Te(C)})}),i.follow("(contract ?name ?form)",m=>{let p=m.flatMap(g=>dt(g)[2]).filter(g=>Array.isArray(g)&&J(g[0])==="posts").flatMap(g=>g.slice(1)).filter(g=>Array.isArray(g?.[2]));c.clear();for(let g of p)c.set(J(g[1]),cy(g));n.replaceChildren(...[...c.values()].sort().map(g=>R("option",{value:g})))})}function Pp(i){let t=Rt("hands-note"),e=R("span",{}),n=R("button",{type:"button"});t.append(e,n);let s=()=>{};n.addEventListener("click",()=>s());let r=(c,h,u)=>{t.hidden=c==="",e.textContent!==c&&(e.textContent=c),n.textContent=h,s=u},o=()=>i.toggle().catch(c=>e.textContent=Te(c)),a=()=>{i.change=null,l()},l=()=>{let{change:c,mine:h}=i,[u]=i.askers;return c&&!c.to?r("You no longer have the arm in hand.","OK",a):c&&c.to!==i.me?r(`${c.to} has taken the arm over.`,"OK",a):h&&u?r(`${u} asks for the arm.`,`Let ${u} have it`,o):c&&h?r(`You have taken the arm over from ${c.from}, who is told.`,"OK",a):r("","",()=>{})};i.onChange(l)}var Ip=[{name:"pan",label:"Pan left / right",index:1},{name:"tilt",label:"Tilt down / up",index:2}];function uy({name:i,label:t},e){let n=xl({label:t,unit:"\xB0",most:30,form:c=>`(set-${i}-rel-pos ${c})`},e),s=qo({label:`${t.split(" ")[0]} speed`,unit:"%",least:1,most:100,value:20,form:c=>`(set-${i}-speed ${c})`},e),r=R("input",{type:"number",id:`${i}-place`,step:"any",required:!0,size:6,"aria-label":`${i} to, degrees`}),o=R("button",{type:"submit"},"Move to"),a=R("button",{type:"button",onclick:()=>e(`(reset-${i})`)},`Reset ${i}`),l=R("form",{class:"row"},R("label",{for:r.id},i),r,"\xB0",o,a);return l.addEventListener("submit",c=>{c.preventDefault(),e(`(set-${i}-pos ${Number(r.value)})`)}),{rows:[n.row,s.row],form:l,percent:s,controls:[n.input,s.input,r,o,a]}}function fy(i,t){let[,,,,e,n,s]=i,r=o=>Math.atan(o/e)*180/Math.PI;return{pan:r(t.x-n),tilt:-r(t.y-s)}}function Lp(i,t,e){let n=Rt("head"),s=new Br(i,()=>"pan-tilt",e,"Commands that the head received, newest first"),r=p=>s.send(p),o=R("span",{id:"head-light",class:"chip"},"no head is present"),a=R("output",{"aria-label":"Where the head looks"},""),l=Ip.map(p=>uy(p,r)),c=(p,g)=>R("button",{type:"button",onclick:()=>r(g)},p),h=[c("Connect","(pt-init)"),c("Disconnect","(pt-close)"),c("Reset both","(reset-all)"),c("Look ahead","(look-ahead)")],u=R("input",{type:"checkbox",id:"click-to-look"}),f=[...h,u,...l.flatMap(p=>p.controls)];n.append(R("div",{class:"row"},o,a,...h),R("div",{class:"slides"},...l.flatMap(p=>p.rows)),...l.map(p=>p.form),R("label",{class:"row"},u,"A click in the camera\u2019s image turns the head there"),R("h2",{},"Commands received"),s.list);let d,m;t.onPoint(p=>{if(!u.checked||!d||!m)return!1;let g=fy(m,p);return r(`(set-pan-pos ${(d[1]+g.pan).toFixed(2)})`),r(`(set-tilt-pos ${(d[2]+g.tilt).toFixed(2)})`),!0}),i.follow("(head ?pan ?tilt ?state)",p=>{d=p.length?dt(p[0]):void 0,a.textContent=d?`pan ${d[1].toFixed(1)}\xB0, tilt ${d[2].toFixed(1)}\xB0, ${J(d[3])}`:""}),i.follow("(camera-model ?eyes ?width ?height ?focal ?cx ?cy ?base)",p=>{let g=p.length?dt(p[0]):void 0;m=g&&[...g]});let y=p=>{let g=p?J(p[1]):"no head is present";o.textContent=p&&J(p[2])?`${g}: ${J(p[2])}`:g,o.className=`chip ${g==="ready"?"good":"bad"}`;for(let v of f)v.disabled=!p,v.title=p?"":"This cell has no head that turns, or its agent is away"};y(),i.follow("(pan-tilt ?state ?trouble)",p=>y(p.length?dt(p[0]):void 0)),i.follow("(head-speed ?pan ?tilt)",p=>{p.length&&Ip.forEach((g,v)=>l[v].percent.put(dt(p[0])[g.index]))})}function Dp(i){let t=location.protocol==="https:";Rt("refused-here").hidden=t,Rt("log-in").hidden=!t,Rt("log-out").hidden=!t,Rt("log-out").addEventListener("click",()=>i.logOut());let e=!1;return Rt("log-in").addEventListener("submit",n=>{n.preventDefault(),e=!0,Rt("log-in-wrong").textContent="",i.logIn(Rt("token").value.trim()),Rt("token").value=""}),n=>{n==="live"&&Rt("refused").close(),n==="refused"&&e&&(Rt("log-in-wrong").textContent="This token is wrong."),n==="refused"&&!Rt("refused").open&&Rt("refused").showModal()}}var dy={closed:"the camera is closed: Connect, in Eyes, opens it",opening:"the camera opens",lost:"the camera is lost"},Np=[{kinds:["colour","left"],title:"Camera"},{kinds:["annotated"],title:"What the eyes follow"}];function py(i){let t=R("canvas",{width:640,height:480,role:"img","aria-label":i}),e=R("span",{class:"quiet"},"no eyes are present"),n=R("figure",{class:"card"},t,R("figcaption",{},R("span",{},i),e));return{canvas:t,note:e,card:n,stream:"",shown:null,end:()=>{}}}function Tl(i,t){(i.width!==t.width||i.height!==t.height)&&(i.width=t.width,i.height=t.height),Ki(i).drawImage(t.bitmap,0,0,t.width,t.height)}function my(i,t){let{canvas:e}=i;Tl(e,t),i.shown={number:t.number,width:t.width,height:t.height},i.note.textContent=`frame ${t.number}`,e.dataset.captured=String(t.captured),e.dataset.frame=String(t.number)}async function gy(i,t,e,n){t.shown=null,t.note.textContent="looking for what was kept \u2026";try{let s=await i.picture(t.stream,e);n()&&(Tl(t.canvas,s),t.note.textContent=`frame ${s.number}, ${tn(s.captured)}`),s.bitmap.close()}catch(s){if(!n())return;Ki(t.canvas).clearRect(0,0,t.canvas.width,t.canvas.height),t.note.textContent=Te(s)}}function _y(i,t){if(!i.shown)return null;let{width:e,height:n,number:s}=i.shown,r=i.canvas.getBoundingClientRect(),o=Math.min(r.width/e,r.height/n),a=Math.round((t.clientX-r.left-(r.width-o*e)/2)/o),l=Math.round((t.clientY-r.top-(r.height-o*n)/2)/o);return a>=0&&l>=0&&a<e&&l<n?{x:a,y:l,frame:s}:null}function Up(i,t){let e=Np.map(f=>py(f.title));Rt("images").append(...e.map(f=>f.card));let n=null,s=[],r=f=>{let d=s.filter(m=>J(m[2])===f).map(m=>J(m[1]));return d.find(m=>m===`${t.server("eyes")}-${f}`)??d[0]},o=()=>Np.forEach((f,d)=>{let m=e[d],y=f.kinds.map(r).find(Boolean)??"";y!==m.stream&&(m.end(),m.stream=y,m.canvas.dataset.stream=y,m.end=y?i.look(y,p=>n===null&&my(m,p)):()=>{},y||(m.note.textContent="no such stream"))});i.followAlways("(stream ?name ?kind ?place)",f=>{s=f.map(dt),o()}),t.onChange(o),i.followAlways("(camera-state ?eyes ?state ?trouble)",f=>{let d=f.map(dt),[,,m,y]=d.find(v=>J(v[1])===t.server("eyes"))??d[0]??[],p=m===void 0?"no eyes are present":dy[J(m)];if(n!==null)return;let g=Jt([p,J(y??"")].filter(Boolean).join(": "),120);for(let v of e)(p||!v.shown)&&(v.note.textContent=p?g:"no image yet")});let a=[],[l]=e;return l.canvas.classList.add("clickable"),l.canvas.addEventListener("click",f=>{let d=_y(l,f);d&&a.some(m=>m(d))}),{onPoint:f=>a.push(f),showMoment:f=>{n=f;let d=()=>n===f;for(let m of e)f!==null&&m.stream&&gy(i,m,f,d)},telling:()=>e[1].stream||e[0].stream}}var xy={connecting:"connecting",live:"live",silent:"silent",lost:"no connection",refused:"no session"},yy=["want","eyes","drive","head"];function Fp(i){let t=Rt("state");return(e,n="")=>{let s=e==="live",r=[xy[e],Jt(n,160)].filter(Boolean).join(e==="silent"?" ":": ");t.textContent!==r&&(t.textContent=r),t.className=`chip ${s?"good":"bad"}`,document.body.dataset.state=e,e!=="connecting"&&(Rt("line-note").hidden=s);for(let o of yy)Rt(o).inert=!s;i.setLive(s)}}function Op(i,t){let e=Rt("past"),n=R("input",{type:"range",id:"moment",min:0,max:1e3,value:1e3,disabled:!0,"aria-label":"Back in time"}),s=R("output",{id:"moment-note",for:"moment"},"now"),r=R("button",{type:"button",id:"back-to-now",disabled:!0},"Now");e.append(R("label",{for:"moment"},"Time"),n,s,r);let o=0,a=()=>Math.round(o+(Date.now()*1e3-o)*Number(n.value)/1e3),l=async h=>{document.body.classList.toggle("past",h!==null),r.disabled=h===null,s.textContent=h===null?"now":`${tn(h)} \u2026`,t.showMoment(h);let u=await i.showMoment(h);h===null||i.moment!==h||(s.textContent=u?Te(u):`as it was at ${tn(h)}`)};n.addEventListener("input",()=>s.textContent=tn(a())),n.addEventListener("change",()=>l(Number(n.value)===1e3?null:a())),r.addEventListener("click",()=>{n.value="1000",l(null)});let c=h=>{for(let{facts:u}of h)o=o?Math.min(o,u[0].when):u[0].when;n.disabled=o===0};return i.followAlways("(agent ?name ?kind ?host)",c),i.followAlways("(event ?n ?kind ?sentence ?detail)",c),h=>{n.value=String((h-o)*1e3/(Date.now()*1e3-o)),l(h)}}function vy(i,t){let e=Array.from({length:i.length+1},()=>Array(t.length+1).fill(0));for(let o=i.length-1;o>=0;--o)for(let a=t.length-1;a>=0;--a)e[o][a]=i[o]===t[a]?e[o+1][a+1]+1:Math.max(e[o+1][a],e[o][a+1]);let n=[],s=0,r=0;for(;s<i.length||r<t.length;)s<i.length&&r<t.length&&i[s]===t[r]?n.push([i[s++],t[r++]]):r===t.length||s<i.length&&e[s+1][r]>=e[s][r+1]?n.push([i[s++],null]):n.push([null,t[r++]]);return n}function Bp(i,t,e){let n=(r,o,a)=>R("td",{class:r?o:""},r&&R("code",{},Jt(r,80)),r&&a&&R("small",{},` ${a}`)),s=vy(i.map(we),t.map(we)).map(([r,o])=>R("tr",{},n(r,o?"kept":"dropped",o?"":e.has(r??"")?"begun":"dropped"),n(o,r?"kept":"made",r?"kept":"new")));return R("table",{class:"plans"},R("thead",{},R("tr",{},R("th",{},"The plan before"),R("th",{},"From here on"))),R("tbody",{},...s))}function or(i){if(!Array.isArray(i)||J(i[0])!=="plan")return null;let[,t,e]=i;return Array.isArray(e)?{goal:t,operations:e}:null}var Sy=(i,t)=>t.every((e,n)=>e===i[i.length-t.length+n]);function My(i,t,e){let n=e.findLastIndex(s=>{let r=or(s[4]);return r!==null&&r.goal===i&&r.operations.map(we).join()===t.join()});return e.slice(n+1)}function kp(i,t,e){let[,n,s]=i,r=s.map(we),o=new Set,a=new Set,l=1/0;for(let[,,u,,f]of My(n,r,e.map(dt))){let d=or(f)?.operations.map(we);if(J(u)==="operation")o.add(we(f));else if(d&&d.length<r.length&&Sy(r,d)){l=r.length-d.length;for(let m of r.slice(l))for(let y of[o,a])y.delete(m)}else if(J(u)==="difference"&&Array.isArray(f))for(let m of f.map(we))r.includes(m)&&a.add(m)}let c=t&&dt(t),h=c&&we(c[2])===r[c[1]];return r.map((u,f)=>h&&f===c[1]?J(c[3]):h&&f<c[1]?a.has(u)?"skipped":"done":a.has(u)?"skipped":f>=l?"still serves":"")}var by={"still serves":"serves"};function wy(i,t){let e=Rt("plan");if(e.replaceChildren(),Rt("plan-note").textContent=i?`for goal ${i[1]}`:"none yet",!i)return;i[2].forEach((s,r)=>{let o=t[r],a=R("li",{class:by[o]??o},R("code",{},Jt(we(s),80)));o&&a.append(R("span",{class:"mark"},o)),o==="running"&&a.setAttribute("aria-current","step"),e.append(a)});let n=e.querySelector(".running");n instanceof HTMLElement&&(e.scrollTop=n.offsetTop-e.offsetTop-e.clientHeight/2)}function zp(i,t){let e,n,s=ii(()=>{let r=t.until(i.moment??1/0);wy(e,e?kp(e,n,r):[])});t.onChange(s),i.follow("(plan ?n ?operations)",r=>{e=r.length?dt(r[0]):void 0,s()}),i.follow("(operation ?i ?operation ?state)",r=>{n=r[0],s()})}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var qs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},$s={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},xm=0,Zu=1,ym=2;var La=1,vm=2,yo=3,Ys=0,ti=1,si=2,mr=0,vo=1,Ju=2,Ku=3,ju=4,Sm=5;var gr=100,Mm=101,bm=102,wm=103,Tm=104,Em=200,Am=201,Cm=202,Rm=203,Qu=204,tf=205,Pm=206,Im=207,Lm=208,Dm=209,Nm=210,Um=211,Fm=212,Om=213,Bm=214,nc=0,ic=1,sc=2,ao=3,rc=4,oc=5,ac=6,lc=7,ef=0,km=1,zm=2,os=0,nf=1,sf=2,rf=3,of=4,af=5,lf=6,cf=7;var hf=300,_r=301,So=302,Uc=303,Fc=304,cc=1e3,ts=1001,hc=1002,Nn=1003,Vm=1004;var Da=1005;var Kn=1006,Oc=1007;var ws=1008;var ri=1009,uf=1010,ff=1011,Mo=1012,Bc=1013,Fi=1014,Oi=1015,Bi=1016,kc=1017,zc=1018,xr=1020,df=35902,pf=35899,mf=1021,gf=1022,ki=1023,Ss=1026,Ts=1027,_f=1028,Vc=1029,Zs=1030,Gc=1031;var Hc=1033,Na=33776,Ua=33777,Fa=33778,Oa=33779,Wc=35840,Xc=35841,qc=35842,$c=35843,Yc=36196,Zc=37492,Jc=37496,Kc=37488,jc=37489,Ba=37490,Qc=37491,th=37808,eh=37809,nh=37810,ih=37811,sh=37812,rh=37813,oh=37814,ah=37815,lh=37816,ch=37817,hh=37818,uh=37819,fh=37820,dh=37821,ph=36492,mh=36494,gh=36495,_h=36283,xh=36284,ka=36285,yh=36286;var sa=2300,uc=2301,tc=2302,Gu=2303,Hu=2400,Wu=2401,Xu=2402;var Gm=3200;var vh=0,Hm=1,Es="",Zn="srgb",ra="srgb-linear",oa="linear",Le="srgb";var ec=7680;var Wm=519,Xm=512,qm=513,$m=514,xf=515,Ym=516,Zm=517,yf=518,vf=519,Sf=35044;var Mf="300 es",bi=2e3,lo=2001;function Ty(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Ey(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function aa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Jm(){let i=aa("canvas");return i.style.display="block",i}var Vp={},co=null;function la(...i){let t="THREE."+i.shift();co?co("log",t,...i):console.log(t,...i)}function Km(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function jt(...i){i=Km(i);let t="THREE."+i.shift();if(co)co("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function ie(...i){i=Km(i);let t="THREE."+i.shift();if(co)co("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function na(...i){let t=i.join(" ");t in Vp||(Vp[t]=!0,jt(...i))}function jm(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var Qm={[nc]:nc,[sc]:ac,[rc]:rc,[ao]:oc,[ic]:ic,[ac]:sc,[lc]:lc,[oc]:ao},Ui=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},zn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Gp=1234567,ro=Math.PI/180,ho=180/Math.PI;function Js(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(zn[i&255]+zn[i>>8&255]+zn[i>>16&255]+zn[i>>24&255]+"-"+zn[t&255]+zn[t>>8&255]+"-"+zn[t>>16&15|64]+zn[t>>24&255]+"-"+zn[e&63|128]+zn[e>>8&255]+"-"+zn[e>>16&255]+zn[e>>24&255]+zn[n&255]+zn[n>>8&255]+zn[n>>16&255]+zn[n>>24&255]).toLowerCase()}function xe(i,t,e){return Math.max(t,Math.min(e,i))}function bf(i,t){return(i%t+t)%t}function Ay(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function Cy(i,t,e){return i!==t?(e-i)/(t-i):0}function ia(i,t,e){return(1-e)*i+e*t}function Ry(i,t,e,n){return ia(i,t,1-Math.exp(-e*n))}function Py(i,t=1){return t-Math.abs(bf(i,t*2)-t)}function Iy(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function Ly(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function Dy(i,t){return i+Math.floor(Math.random()*(t-i+1))}function Ny(i,t){return i+Math.random()*(t-i)}function Uy(i){return i*(.5-Math.random())}function Fy(i){i!==void 0&&(Gp=i);let t=Gp+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Oy(i){return i*ro}function By(i){return i*ho}function ky(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function zy(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function wf(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Vy(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),u=r((t-n)/2),f=o((t-n)/2),d=r((n-t)/2),m=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*u,l*f,a*c);break;case"YZY":i.set(l*f,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*f,a*h,a*c);break;case"XZX":i.set(a*h,l*m,l*d,a*c);break;case"YXY":i.set(l*d,a*h,l*m,a*c);break;case"ZYZ":i.set(l*m,l*d,a*h,a*c);break;default:jt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Sh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Tf(i,t){if(t.constructor===Float32Array)return i;let e=Sh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Ef(i,t){if(t.constructor===Float32Array)return i;let e=Sh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var Af={DEG2RAD:ro,RAD2DEG:ho,generateUUID:Js,clamp:xe,euclideanModulo:bf,mapLinear:Ay,inverseLerp:Cy,lerp:ia,damp:Ry,pingpong:Py,smoothstep:Iy,smootherstep:Ly,randInt:Dy,randFloat:Ny,randFloatSpread:Uy,seededRandom:Fy,degToRad:Oy,radToDeg:By,isPowerOfTwo:ky,ceilPowerOfTwo:zy,floorPowerOfTwo:wf,setQuaternionFromProperEuler:Vy,normalize:Ef,denormalize:Tf},Zt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(xe(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(xe(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},jn=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],f=r[o+0],d=r[o+1],m=r[o+2],y=r[o+3];if(u!==y||l!==f||c!==d||h!==m){let p=l*f+c*d+h*m+u*y;p<0&&(f=-f,d=-d,m=-m,y=-y,p=-p);let g=1-a;if(p<.9995){let v=Math.acos(p),C=Math.sin(v);g=Math.sin(g*v)/C,a=Math.sin(a*v)/C,l=l*g+f*a,c=c*g+d*a,h=h*g+m*a,u=u*g+y*a}else{l=l*g+f*a,c=c*g+d*a,h=h*g+m*a,u=u*g+y*a;let v=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=v,c*=v,h*=v,u*=v}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],f=r[o+1],d=r[o+2],m=r[o+3];return t[e]=a*m+h*u+l*d-c*f,t[e+1]=l*m+h*f+c*u-a*d,t[e+2]=c*m+h*d+a*f-l*u,t[e+3]=h*m-a*u-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),f=l(n/2),d=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=f*h*u+c*d*m,this._y=c*d*u-f*h*m,this._z=c*h*m+f*d*u,this._w=c*h*u-f*d*m;break;case"YXZ":this._x=f*h*u+c*d*m,this._y=c*d*u-f*h*m,this._z=c*h*m-f*d*u,this._w=c*h*u+f*d*m;break;case"ZXY":this._x=f*h*u-c*d*m,this._y=c*d*u+f*h*m,this._z=c*h*m+f*d*u,this._w=c*h*u-f*d*m;break;case"ZYX":this._x=f*h*u-c*d*m,this._y=c*d*u+f*h*m,this._z=c*h*m-f*d*u,this._w=c*h*u+f*d*m;break;case"YZX":this._x=f*h*u+c*d*m,this._y=c*d*u+f*h*m,this._z=c*h*m-f*d*u,this._w=c*h*u-f*d*m;break;case"XZY":this._x=f*h*u-c*d*m,this._y=c*d*u-f*h*m,this._z=c*h*m+f*d*u,this._w=c*h*u+f*d*m;break;default:jt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],f=n+a+u;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(h-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(n>a&&n>u){let d=2*Math.sqrt(1+n-a-u);this._w=(h-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>u){let d=2*Math.sqrt(1+a-n-u);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+h)/d}else{let d=2*Math.sqrt(1+u-n-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+h)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(xe(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},X=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Hp.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Hp.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this.z=xe(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this.z=xe(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(xe(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return yu.copy(this).projectOnVector(t),this.sub(yu)}reflect(t){return this.sub(yu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(xe(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},yu=new X,Hp=new jn,re=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],f=n[2],d=n[5],m=n[8],y=s[0],p=s[3],g=s[6],v=s[1],C=s[4],S=s[7],P=s[2],E=s[5],_=s[8];return r[0]=o*y+a*v+l*P,r[3]=o*p+a*C+l*E,r[6]=o*g+a*S+l*_,r[1]=c*y+h*v+u*P,r[4]=c*p+h*C+u*E,r[7]=c*g+h*S+u*_,r[2]=f*y+d*v+m*P,r[5]=f*p+d*C+m*E,r[8]=f*g+d*S+m*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,f=a*l-h*r,d=c*r-o*l,m=e*u+n*f+s*d;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/m;return t[0]=u*y,t[1]=(s*c-h*n)*y,t[2]=(a*n-s*o)*y,t[3]=f*y,t[4]=(h*e-s*l)*y,t[5]=(s*r-a*e)*y,t[6]=d*y,t[7]=(n*l-c*e)*y,t[8]=(o*e-n*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return na("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(vu.makeScale(t,e)),this}rotate(t){return na("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(vu.makeRotation(-t)),this}translate(t,e){return na("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(vu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},vu=new re,Wp=new re().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Xp=new re().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Gy(){let i={enabled:!0,workingColorSpace:ra,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Le&&(s.r=vs(s.r),s.g=vs(s.g),s.b=vs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Le&&(s.r=oo(s.r),s.g=oo(s.g),s.b=oo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Es?oa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[ra]:{primaries:t,whitePoint:n,transfer:oa,toXYZ:Wp,fromXYZ:Xp,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Zn},outputColorSpaceConfig:{drawingBufferColorSpace:Zn}},[Zn]:{primaries:t,whitePoint:n,transfer:Le,toXYZ:Wp,fromXYZ:Xp,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Zn}}}),i}var Se=Gy();function vs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function oo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Gr,fc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Gr===void 0&&(Gr=aa("canvas")),Gr.width=t.width,Gr.height=t.height;let s=Gr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Gr}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=aa("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=vs(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(vs(e[n]/255)*255):e[n]=vs(e[n]);return{data:e,width:t.width,height:t.height}}else return jt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Hy=0,uo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Hy++}),this.uuid=Js(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Su(s[o].image)):r.push(Su(s[o]))}else r=Su(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function Su(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?fc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(jt("Texture: Unable to serialize Texture."),{})}var Wy=0,Mu=new X,Qn=class i extends Ui{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=ts,s=ts,r=Kn,o=ws,a=ki,l=ri,c=i.DEFAULT_ANISOTROPY,h=Es){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Wy++}),this.uuid=Js(),this.name="",this.source=new uo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Zt(0,0),this.repeat=new Zt(1,1),this.center=new Zt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new re,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Mu).x}get height(){return this.source.getSize(Mu).y}get depth(){return this.source.getSize(Mu).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){jt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){jt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==hf)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case cc:t.x=t.x-Math.floor(t.x);break;case ts:t.x=t.x<0?0:1;break;case hc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case cc:t.y=t.y-Math.floor(t.y);break;case ts:t.y=t.y<0?0:1;break;case hc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Qn.DEFAULT_IMAGE=null;Qn.DEFAULT_MAPPING=hf;Qn.DEFAULT_ANISOTROPY=1;var je=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],f=l[1],d=l[5],m=l[9],y=l[2],p=l[6],g=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-y)<.01&&Math.abs(m-p)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+y)<.1&&Math.abs(m+p)<.1&&Math.abs(c+d+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let C=(c+1)/2,S=(d+1)/2,P=(g+1)/2,E=(h+f)/4,_=(u+y)/4,b=(m+p)/4;return C>S&&C>P?C<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(C),s=E/n,r=_/n):S>P?S<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),n=E/s,r=b/s):P<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),n=_/r,s=b/r),this.set(n,s,r,e),this}let v=Math.sqrt((p-m)*(p-m)+(u-y)*(u-y)+(f-h)*(f-h));return Math.abs(v)<.001&&(v=1),this.x=(p-m)/v,this.y=(u-y)/v,this.z=(f-h)/v,this.w=Math.acos((c+d+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this.z=xe(this.z,t.z,e.z),this.w=xe(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this.z=xe(this.z,t,e),this.w=xe(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(xe(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},dc=class extends Ui{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Kn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new je(0,0,t,e),this.scissorTest=!1,this.viewport=new je(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Qn({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Kn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new uo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},pi=class extends dc{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},ca=class extends Qn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Nn,this.minFilter=Nn,this.wrapR=ts,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var pc=class extends Qn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Nn,this.minFilter=Nn,this.wrapR=ts,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var De=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,h,u,f,d,m,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,u,f,d,m,y,p)}set(t,e,n,s,r,o,a,l,c,h,u,f,d,m,y,p){let g=this.elements;return g[0]=t,g[4]=e,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=f,g[3]=d,g[7]=m,g[11]=y,g[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/Hr.setFromMatrixColumn(t,0).length(),r=1/Hr.setFromMatrixColumn(t,1).length(),o=1/Hr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let f=o*h,d=o*u,m=a*h,y=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=d+m*c,e[5]=f-y*c,e[9]=-a*l,e[2]=y-f*c,e[6]=m+d*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*h,d=l*u,m=c*h,y=c*u;e[0]=f+y*a,e[4]=m*a-d,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=d*a-m,e[6]=y+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*h,d=l*u,m=c*h,y=c*u;e[0]=f-y*a,e[4]=-o*u,e[8]=m+d*a,e[1]=d+m*a,e[5]=o*h,e[9]=y-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*h,d=o*u,m=a*h,y=a*u;e[0]=l*h,e[4]=m*c-d,e[8]=f*c+y,e[1]=l*u,e[5]=y*c+f,e[9]=d*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,d=o*c,m=a*l,y=a*c;e[0]=l*h,e[4]=y-f*u,e[8]=m*u+d,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=d*u+m,e[10]=f-y*u}else if(t.order==="XZY"){let f=o*l,d=o*c,m=a*l,y=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=f*u+y,e[5]=o*h,e[9]=d*u-m,e[2]=m*u-d,e[6]=a*h,e[10]=y*u+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Xy,t,qy)}lookAt(t,e,n){let s=this.elements;return ui.subVectors(t,e),ui.lengthSq()===0&&(ui.z=1),ui.normalize(),Fs.crossVectors(n,ui),Fs.lengthSq()===0&&(Math.abs(n.z)===1?ui.x+=1e-4:ui.z+=1e-4,ui.normalize(),Fs.crossVectors(n,ui)),Fs.normalize(),El.crossVectors(ui,Fs),s[0]=Fs.x,s[4]=El.x,s[8]=ui.x,s[1]=Fs.y,s[5]=El.y,s[9]=ui.y,s[2]=Fs.z,s[6]=El.z,s[10]=ui.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],f=n[9],d=n[13],m=n[2],y=n[6],p=n[10],g=n[14],v=n[3],C=n[7],S=n[11],P=n[15],E=s[0],_=s[4],b=s[8],O=s[12],D=s[1],A=s[5],F=s[9],G=s[13],N=s[2],V=s[6],$=s[10],H=s[14],ct=s[3],K=s[7],tt=s[11],nt=s[15];return r[0]=o*E+a*D+l*N+c*ct,r[4]=o*_+a*A+l*V+c*K,r[8]=o*b+a*F+l*$+c*tt,r[12]=o*O+a*G+l*H+c*nt,r[1]=h*E+u*D+f*N+d*ct,r[5]=h*_+u*A+f*V+d*K,r[9]=h*b+u*F+f*$+d*tt,r[13]=h*O+u*G+f*H+d*nt,r[2]=m*E+y*D+p*N+g*ct,r[6]=m*_+y*A+p*V+g*K,r[10]=m*b+y*F+p*$+g*tt,r[14]=m*O+y*G+p*H+g*nt,r[3]=v*E+C*D+S*N+P*ct,r[7]=v*_+C*A+S*V+P*K,r[11]=v*b+C*F+S*$+P*tt,r[15]=v*O+C*G+S*H+P*nt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],f=t[10],d=t[14],m=t[3],y=t[7],p=t[11],g=t[15],v=l*d-c*f,C=a*d-c*u,S=a*f-l*u,P=o*d-c*h,E=o*f-l*h,_=o*u-a*h;return e*(y*v-p*C+g*S)-n*(m*v-p*P+g*E)+s*(m*C-y*P+g*_)-r*(m*S-y*E+p*_)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],f=t[10],d=t[11],m=t[12],y=t[13],p=t[14],g=t[15],v=e*a-n*o,C=e*l-s*o,S=e*c-r*o,P=n*l-s*a,E=n*c-r*a,_=s*c-r*l,b=h*y-u*m,O=h*p-f*m,D=h*g-d*m,A=u*p-f*y,F=u*g-d*y,G=f*g-d*p,N=v*G-C*F+S*A+P*D-E*O+_*b;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/N;return t[0]=(a*G-l*F+c*A)*V,t[1]=(s*F-n*G-r*A)*V,t[2]=(y*_-p*E+g*P)*V,t[3]=(f*E-u*_-d*P)*V,t[4]=(l*D-o*G-c*O)*V,t[5]=(e*G-s*D+r*O)*V,t[6]=(p*S-m*_-g*C)*V,t[7]=(h*_-f*S+d*C)*V,t[8]=(o*F-a*D+c*b)*V,t[9]=(n*D-e*F-r*b)*V,t[10]=(m*E-y*S+g*v)*V,t[11]=(u*S-h*E-d*v)*V,t[12]=(a*O-o*A-l*b)*V,t[13]=(e*A-n*O+s*b)*V,t[14]=(y*C-m*P-p*v)*V,t[15]=(h*P-u*C+f*v)*V,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,f=r*c,d=r*h,m=r*u,y=o*h,p=o*u,g=a*u,v=l*c,C=l*h,S=l*u,P=n.x,E=n.y,_=n.z;return s[0]=(1-(y+g))*P,s[1]=(d+S)*P,s[2]=(m-C)*P,s[3]=0,s[4]=(d-S)*E,s[5]=(1-(f+g))*E,s[6]=(p+v)*E,s[7]=0,s[8]=(m+C)*_,s[9]=(p-v)*_,s[10]=(1-(f+y))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=Hr.set(s[0],s[1],s[2]).length(),a=Hr.set(s[4],s[5],s[6]).length(),l=Hr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ii.copy(this);let c=1/o,h=1/a,u=1/l;return Ii.elements[0]*=c,Ii.elements[1]*=c,Ii.elements[2]*=c,Ii.elements[4]*=h,Ii.elements[5]*=h,Ii.elements[6]*=h,Ii.elements[8]*=u,Ii.elements[9]*=u,Ii.elements[10]*=u,e.setFromRotationMatrix(Ii),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=bi,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(n-s),f=(e+t)/(e-t),d=(n+s)/(n-s),m,y;if(l)m=r/(o-r),y=o*r/(o-r);else if(a===bi)m=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===lo)m=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=u,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=bi,l=!1){let c=this.elements,h=2/(e-t),u=2/(n-s),f=-(e+t)/(e-t),d=-(n+s)/(n-s),m,y;if(l)m=1/(o-r),y=o/(o-r);else if(a===bi)m=-2/(o-r),y=-(o+r)/(o-r);else if(a===lo)m=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=u,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Hr=new X,Ii=new De,Xy=new X(0,0,0),qy=new X(1,1,1),Fs=new X,El=new X,ui=new X,qp=new De,$p=new jn,Ms=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(xe(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-xe(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(xe(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-xe(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(xe(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-xe(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,d),this._y=0);break;default:jt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return qp.makeRotationFromQuaternion(t),this.setFromRotationMatrix(qp,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return $p.setFromEuler(this),this.setFromQuaternion($p,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ms.DEFAULT_ORDER="XYZ";var ha=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},$y=0,Yp=new X,Wr=new jn,ms=new De,Al=new X,Yo=new X,Yy=new X,Zy=new jn,Zp=new X(1,0,0),Jp=new X(0,1,0),Kp=new X(0,0,1),jp={type:"added"},Jy={type:"removed"},Xr={type:"childadded",child:null},bu={type:"childremoved",child:null},Un=class i extends Ui{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:$y++}),this.uuid=Js(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new X,e=new Ms,n=new jn,s=new X(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new De},normalMatrix:{value:new re}}),this.matrix=new De,this.matrixWorld=new De,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ha,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Wr.setFromAxisAngle(t,e),this.quaternion.multiply(Wr),this}rotateOnWorldAxis(t,e){return Wr.setFromAxisAngle(t,e),this.quaternion.premultiply(Wr),this}rotateX(t){return this.rotateOnAxis(Zp,t)}rotateY(t){return this.rotateOnAxis(Jp,t)}rotateZ(t){return this.rotateOnAxis(Kp,t)}translateOnAxis(t,e){return Yp.copy(t).applyQuaternion(this.quaternion),this.position.add(Yp.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Zp,t)}translateY(t){return this.translateOnAxis(Jp,t)}translateZ(t){return this.translateOnAxis(Kp,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ms.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Al.copy(t):Al.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Yo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ms.lookAt(Yo,Al,this.up):ms.lookAt(Al,Yo,this.up),this.quaternion.setFromRotationMatrix(ms),s&&(ms.extractRotation(s.matrixWorld),Wr.setFromRotationMatrix(ms),this.quaternion.premultiply(Wr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ie("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(jp),Xr.child=t,this.dispatchEvent(Xr),Xr.child=null):ie("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Jy),bu.child=t,this.dispatchEvent(bu),bu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ms.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ms.multiply(t.parent.matrixWorld)),t.applyMatrix4(ms),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(jp),Xr.child=t,this.dispatchEvent(Xr),Xr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Yo,t,Yy),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Yo,Zy,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),f=o(t.skeletons),d=o(t.animations),m=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),m.length>0&&(n.nodes=m)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Un.DEFAULT_UP=new X(0,1,0);Un.DEFAULT_MATRIX_AUTO_UPDATE=!0;Un.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var On=class extends Un{constructor(){super(),this.isGroup=!0,this.type="Group"}},Ky={type:"move"},fo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new On,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new On,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new X,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new X),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new On,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new X,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new X,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let p=e.getJointPose(y,n),g=this._getHandJoint(c,y);p!==null&&(g.matrix.fromArray(p.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=p.radius),g.visible=p!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),d=.02,m=.005;c.inputState.pinching&&f>d+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Ky)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new On;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},tg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Os={h:0,s:0,l:0},Cl={h:0,s:0,l:0};function wu(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var he=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Zn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Se.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=Se.workingColorSpace){return this.r=t,this.g=e,this.b=n,Se.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=Se.workingColorSpace){if(t=bf(t,1),e=xe(e,0,1),n=xe(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=wu(o,r,t+1/3),this.g=wu(o,r,t),this.b=wu(o,r,t-1/3)}return Se.colorSpaceToWorking(this,s),this}setStyle(t,e=Zn){function n(r){r!==void 0&&parseFloat(r)<1&&jt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:jt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);jt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Zn){let n=tg[t.toLowerCase()];return n!==void 0?this.setHex(n,e):jt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=vs(t.r),this.g=vs(t.g),this.b=vs(t.b),this}copyLinearToSRGB(t){return this.r=oo(t.r),this.g=oo(t.g),this.b=oo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Zn){return Se.workingToColorSpace(Vn.copy(this),t),Math.round(xe(Vn.r*255,0,255))*65536+Math.round(xe(Vn.g*255,0,255))*256+Math.round(xe(Vn.b*255,0,255))}getHexString(t=Zn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Se.workingColorSpace){Se.workingToColorSpace(Vn.copy(this),e);let n=Vn.r,s=Vn.g,r=Vn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=Se.workingColorSpace){return Se.workingToColorSpace(Vn.copy(this),e),t.r=Vn.r,t.g=Vn.g,t.b=Vn.b,t}getStyle(t=Zn){Se.workingToColorSpace(Vn.copy(this),t);let e=Vn.r,n=Vn.g,s=Vn.b;return t!==Zn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Os),this.setHSL(Os.h+t,Os.s+e,Os.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Os),t.getHSL(Cl);let n=ia(Os.h,Cl.h,e),s=ia(Os.s,Cl.s,e),r=ia(Os.l,Cl.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Vn=new he;he.NAMES=tg;var ua=class extends Un{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ms,this.environmentIntensity=1,this.environmentRotation=new Ms,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Li=new X,gs=new X,Tu=new X,_s=new X,qr=new X,$r=new X,Qp=new X,Eu=new X,Au=new X,Cu=new X,Ru=new je,Pu=new je,Iu=new je,Qi=class i{constructor(t=new X,e=new X,n=new X){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Li.subVectors(t,e),s.cross(Li);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Li.subVectors(s,e),gs.subVectors(n,e),Tu.subVectors(t,e);let o=Li.dot(Li),a=Li.dot(gs),l=Li.dot(Tu),c=gs.dot(gs),h=gs.dot(Tu),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let f=1/u,d=(c*l-a*h)*f,m=(o*h-a*l)*f;return r.set(1-d-m,m,d)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,_s)===null?!1:_s.x>=0&&_s.y>=0&&_s.x+_s.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,_s)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,_s.x),l.addScaledVector(o,_s.y),l.addScaledVector(a,_s.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return Ru.setScalar(0),Pu.setScalar(0),Iu.setScalar(0),Ru.fromBufferAttribute(t,e),Pu.fromBufferAttribute(t,n),Iu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Ru,r.x),o.addScaledVector(Pu,r.y),o.addScaledVector(Iu,r.z),o}static isFrontFacing(t,e,n,s){return Li.subVectors(n,e),gs.subVectors(t,e),Li.cross(gs).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Li.subVectors(this.c,this.b),gs.subVectors(this.a,this.b),Li.cross(gs).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;qr.subVectors(s,n),$r.subVectors(r,n),Eu.subVectors(t,n);let l=qr.dot(Eu),c=$r.dot(Eu);if(l<=0&&c<=0)return e.copy(n);Au.subVectors(t,s);let h=qr.dot(Au),u=$r.dot(Au);if(h>=0&&u<=h)return e.copy(s);let f=l*u-h*c;if(f<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector(qr,o);Cu.subVectors(t,r);let d=qr.dot(Cu),m=$r.dot(Cu);if(m>=0&&d<=m)return e.copy(r);let y=d*c-l*m;if(y<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(n).addScaledVector($r,a);let p=h*m-d*u;if(p<=0&&u-h>=0&&d-m>=0)return Qp.subVectors(r,s),a=(u-h)/(u-h+(d-m)),e.copy(s).addScaledVector(Qp,a);let g=1/(p+y+f);return o=y*g,a=f*g,e.copy(n).addScaledVector(qr,o).addScaledVector($r,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Vs=class{constructor(t=new X(1/0,1/0,1/0),e=new X(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Di.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Di.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Di.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Di):Di.fromBufferAttribute(r,o),Di.applyMatrix4(t.matrixWorld),this.expandByPoint(Di);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Rl.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Rl.copy(n.boundingBox)),Rl.applyMatrix4(t.matrixWorld),this.union(Rl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Di),Di.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Zo),Pl.subVectors(this.max,Zo),Yr.subVectors(t.a,Zo),Zr.subVectors(t.b,Zo),Jr.subVectors(t.c,Zo),Bs.subVectors(Zr,Yr),ks.subVectors(Jr,Zr),ar.subVectors(Yr,Jr);let e=[0,-Bs.z,Bs.y,0,-ks.z,ks.y,0,-ar.z,ar.y,Bs.z,0,-Bs.x,ks.z,0,-ks.x,ar.z,0,-ar.x,-Bs.y,Bs.x,0,-ks.y,ks.x,0,-ar.y,ar.x,0];return!Lu(e,Yr,Zr,Jr,Pl)||(e=[1,0,0,0,1,0,0,0,1],!Lu(e,Yr,Zr,Jr,Pl))?!1:(Il.crossVectors(Bs,ks),e=[Il.x,Il.y,Il.z],Lu(e,Yr,Zr,Jr,Pl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Di).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Di).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(xs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),xs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),xs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),xs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),xs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),xs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),xs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),xs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(xs),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},xs=[new X,new X,new X,new X,new X,new X,new X,new X],Di=new X,Rl=new Vs,Yr=new X,Zr=new X,Jr=new X,Bs=new X,ks=new X,ar=new X,Zo=new X,Pl=new X,Il=new X,lr=new X;function Lu(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){lr.fromArray(i,r);let a=s.x*Math.abs(lr.x)+s.y*Math.abs(lr.y)+s.z*Math.abs(lr.z),l=t.dot(lr),c=e.dot(lr),h=n.dot(lr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var _n=new X,Ll=new Zt,jy=0,Ni=class extends Ui{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:jy++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Sf,this.updateRanges=[],this.gpuType=Oi,this.version=0,this._normalizationScale=t!==void 0?Sh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Ll.fromBufferAttribute(this,e),Ll.applyMatrix3(t),this.setXY(e,Ll.x,Ll.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)_n.fromBufferAttribute(this,e),_n.applyMatrix3(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)_n.fromBufferAttribute(this,e),_n.applyMatrix4(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)_n.fromBufferAttribute(this,e),_n.applyNormalMatrix(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)_n.fromBufferAttribute(this,e),_n.transformDirection(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Tf(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Ef(t,this.array)}};var fa=class extends Ni{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var da=class extends Ni{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Re=class extends Ni{constructor(t,e,n){super(new Float32Array(t),e,n)}},Qy=new Vs,Jo=new X,Du=new X,ur=class{constructor(t=new X,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Qy.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Jo.subVectors(t,this.center);let e=Jo.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Jo,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Du.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Jo.copy(t.center).add(Du)),this.expandByPoint(Jo.copy(t.center).sub(Du))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},tv=0,Mi=new De,Nu=new Un,Kr=new X,fi=new Vs,Ko=new Vs,Dn=new X,ln=class i extends Ui{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:tv++}),this.uuid=Js(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Ty(t)?da:fa)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new re().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Mi.makeRotationFromQuaternion(t),this.applyMatrix4(Mi),this}rotateX(t){return Mi.makeRotationX(t),this.applyMatrix4(Mi),this}rotateY(t){return Mi.makeRotationY(t),this.applyMatrix4(Mi),this}rotateZ(t){return Mi.makeRotationZ(t),this.applyMatrix4(Mi),this}translate(t,e,n){return Mi.makeTranslation(t,e,n),this.applyMatrix4(Mi),this}scale(t,e,n){return Mi.makeScale(t,e,n),this.applyMatrix4(Mi),this}lookAt(t){return Nu.lookAt(t),Nu.updateMatrix(),this.applyMatrix4(Nu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Kr).negate(),this.translate(Kr.x,Kr.y,Kr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Re(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&jt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Vs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ie("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new X(-1/0,-1/0,-1/0),new X(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];fi.setFromBufferAttribute(r),this.morphTargetsRelative?(Dn.addVectors(this.boundingBox.min,fi.min),this.boundingBox.expandByPoint(Dn),Dn.addVectors(this.boundingBox.max,fi.max),this.boundingBox.expandByPoint(Dn)):(this.boundingBox.expandByPoint(fi.min),this.boundingBox.expandByPoint(fi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ie('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ur);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ie("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new X,1/0);return}if(t){let n=this.boundingSphere.center;if(fi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Ko.setFromBufferAttribute(a),this.morphTargetsRelative?(Dn.addVectors(fi.min,Ko.min),fi.expandByPoint(Dn),Dn.addVectors(fi.max,Ko.max),fi.expandByPoint(Dn)):(fi.expandByPoint(Ko.min),fi.expandByPoint(Ko.max))}fi.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Dn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Dn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Dn.fromBufferAttribute(a,c),l&&(Kr.fromBufferAttribute(t,c),Dn.add(Kr)),s=Math.max(s,n.distanceToSquared(Dn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ie('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ie("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Ni(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let O=0;O<n.count;O++)a[O]=new X,l[O]=new X;let h=new X,u=new X,f=new X,d=new Zt,m=new Zt,y=new Zt,p=new X,g=new X;function v(O,D,A){c[O]=c[D]=c[A]=1,h.fromBufferAttribute(n,O),u.fromBufferAttribute(n,D),f.fromBufferAttribute(n,A),d.fromBufferAttribute(r,O),m.fromBufferAttribute(r,D),y.fromBufferAttribute(r,A),u.sub(h),f.sub(h),m.sub(d),y.sub(d);let F=1/(m.x*y.y-y.x*m.y);isFinite(F)&&(p.copy(u).multiplyScalar(y.y).addScaledVector(f,-m.y).multiplyScalar(F),g.copy(f).multiplyScalar(m.x).addScaledVector(u,-y.x).multiplyScalar(F),a[O].add(p),a[D].add(p),a[A].add(p),l[O].add(g),l[D].add(g),l[A].add(g))}let C=this.groups;C.length===0&&(C=[{start:0,count:t.count}]);for(let O=0,D=C.length;O<D;++O){let A=C[O],F=A.start,G=A.count;for(let N=F,V=F+G;N<V;N+=3)v(t.getX(N+0),t.getX(N+1),t.getX(N+2))}let S=new X,P=new X,E=new X,_=new X;function b(O){E.fromBufferAttribute(s,O),_.copy(E);let D=a[O];S.copy(D),S.sub(E.multiplyScalar(E.dot(D))).normalize(),P.crossVectors(_,D);let F=P.dot(l[O])<0?-1:1;o.setXYZW(O,S.x,S.y,S.z,F)}for(let O=0,D=n.count;O<D;++O)c[O]&&b(O);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Ni(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let s=new X,r=new X,o=new X,a=new X,l=new X,c=new X,h=new X,u=new X;if(t)for(let f=0,d=t.count;f<d;f+=3){let m=t.getX(f+0),y=t.getX(f+1),p=t.getX(f+2);s.fromBufferAttribute(e,m),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,p),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,m),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,p),a.add(h),l.add(h),c.add(h),n.setXYZ(m,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(f+0,h.x,h.y,h.z),n.setXYZ(f+1,h.x,h.y,h.z),n.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Dn.fromBufferAttribute(t,e),Dn.normalize(),t.setXYZ(e,Dn.x,Dn.y,Dn.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h),d=0,m=0;for(let y=0,p=l.length;y<p;y++){a.isInterleavedBufferAttribute?d=l[y]*a.data.stride+a.offset:d=l[y]*h;for(let g=0;g<h;g++)f[m++]=c[d++]}return new Ni(f,h,u)}if(this.index===null)return jt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let f=c[h],d=t(f,n);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){let d=c[u];h.push(d.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let f=0,d=u.length;f<d;f++)h.push(u[f].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},mc=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Sf,this.updateRanges=[],this.version=0,this.uuid=Js()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,n){t*=this.stride,n*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[n+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=tm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let n=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=tm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function tm(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Js()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var Yn=new X,pa=class i{constructor(t,e,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=n,this.normalized=s,this._normalizationScale=t!==void 0?Sh(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,n=this.data.count;e<n;e++)Yn.fromBufferAttribute(this,e),Yn.applyMatrix4(t),this.setXYZ(e,Yn.x,Yn.y,Yn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Yn.fromBufferAttribute(this,e),Yn.applyNormalMatrix(t),this.setXYZ(e,Yn.x,Yn.y,Yn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Yn.fromBufferAttribute(this,e),Yn.transformDirection(t),this.setXYZ(e,Yn.x,Yn.y,Yn.z);return this}getComponent(t,e){let n=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.data.array[t*this.data.stride+this.offset+e]=n,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.data.array[t+0]=e,this.data.array[t+1]=n,this}setXYZ(t,e,n,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){la("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Ni(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new i(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){la("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Tf(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Ef(t,this.data.array)}},Uu=new X,ev=new X,nv=new re,di=class{constructor(t=new X(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Uu.subVectors(n,e).cross(ev.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(Uu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||nv.getNormalMatrix(t),s=this.coplanarPoint(Uu).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},iv=0,es=class extends Ui{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:iv++}),this.uuid=Js(),this.name="",this.type="Material",this.blending=vo,this.side=Ys,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Qu,this.blendDst=tf,this.blendEquation=gr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new he(0,0,0),this.blendAlpha=0,this.depthFunc=ao,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Wm,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ec,this.stencilZFail=ec,this.stencilZPass=ec,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){jt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){jt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new he().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new di().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Zt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Zt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},po=class extends es{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new he(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},jr,jo=new X,Qr=new X,to=new X,eo=new Zt,Qo=new Zt,eg=new De,Dl=new X,ta=new X,Nl=new X,em=new Zt,Fu=new Zt,nm=new Zt,ma=class extends Un{constructor(t=new po){if(super(),this.isSprite=!0,this.type="Sprite",jr===void 0){jr=new ln;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new mc(e,5);jr.setIndex([0,1,2,0,2,3]),jr.setAttribute("position",new pa(n,3,0,!1)),jr.setAttribute("uv",new pa(n,2,3,!1))}this.geometry=jr,this.material=t,this.center=new Zt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&ie('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),Qr.setFromMatrixScale(this.matrixWorld),eg.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),to.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&Qr.multiplyScalar(-to.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;Ul(Dl.set(-.5,-.5,0),to,o,Qr,s,r),Ul(ta.set(.5,-.5,0),to,o,Qr,s,r),Ul(Nl.set(.5,.5,0),to,o,Qr,s,r),em.set(0,0),Fu.set(1,0),nm.set(1,1);let a=t.ray.intersectTriangle(Dl,ta,Nl,!1,jo);if(a===null&&(Ul(ta.set(-.5,.5,0),to,o,Qr,s,r),Fu.set(0,1),a=t.ray.intersectTriangle(Dl,Nl,ta,!1,jo),a===null))return;let l=t.ray.origin.distanceTo(jo);l<t.near||l>t.far||e.push({distance:l,point:jo.clone(),uv:Qi.getInterpolation(jo,Dl,ta,Nl,em,Fu,nm,new Zt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function Ul(i,t,e,n,s,r){eo.subVectors(i,e).addScalar(.5).multiply(n),s!==void 0?(Qo.x=r*eo.x-s*eo.y,Qo.y=s*eo.x+r*eo.y):Qo.copy(eo),i.copy(t),i.x+=Qo.x,i.y+=Qo.y,i.applyMatrix4(eg)}var ys=new X,Ou=new X,Fl=new X,Ol=new X,fr=class{constructor(t=new X,e=new X(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,ys)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=ys.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(ys.copy(this.origin).addScaledVector(this.direction,e),ys.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Ou.copy(t).add(e).multiplyScalar(.5),Fl.copy(e).sub(t).normalize(),Ol.copy(this.origin).sub(Ou);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Fl),a=Ol.dot(this.direction),l=-Ol.dot(Fl),c=Ol.lengthSq(),h=Math.abs(1-o*o),u,f,d,m;if(h>0)if(u=o*l-a,f=o*a-l,m=r*h,u>=0)if(f>=-m)if(f<=m){let y=1/h;u*=y,f*=y,d=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f<=-m?(u=Math.max(0,-(-o*r+a)),f=u>0?-r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c):f<=m?(u=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(u=Math.max(0,-(o*r+a)),f=u>0?r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c);else f=o>0?-r:r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Ou).addScaledVector(Fl,f),d}intersectSphere(t,e){if(t.radius<0)return null;ys.subVectors(t.center,this.origin);let n=ys.dot(this.direction),s=ys.dot(ys)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),h>=0?(r=(t.min.y-f.y)*h,o=(t.max.y-f.y)*h):(r=(t.max.y-f.y)*h,o=(t.min.y-f.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-f.z)*u,l=(t.max.z-f.z)*u):(a=(t.max.z-f.z)*u,l=(t.min.z-f.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,ys)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,f=t.y-o.y,d=t.z-o.z,m=e.x-o.x,y=e.y-o.y,p=e.z-o.z,g=n.x-o.x,v=n.y-o.y,C=n.z-o.z,S=Math.abs(l),P=Math.abs(c),E=Math.abs(h),_,b,O,D,A,F,G,N,V,$,H,ct;if(S>=P&&S>=E?(O=l,F=u,V=m,ct=g,l>=0?(_=c,b=h,D=f,A=d,G=y,N=p,$=v,H=C):(_=h,b=c,D=d,A=f,G=p,N=y,$=C,H=v)):P>=E?(O=c,F=f,V=y,ct=v,c>=0?(_=h,b=l,D=d,A=u,G=p,N=m,$=C,H=g):(_=l,b=h,D=u,A=d,G=m,N=p,$=g,H=C)):(O=h,F=d,V=p,ct=C,h>=0?(_=l,b=c,D=u,A=f,G=m,N=y,$=g,H=v):(_=c,b=l,D=f,A=u,G=y,N=m,$=v,H=g)),O===0)return null;let K=_/O,tt=b/O,nt=1/O,pt=D-K*F,ft=A-tt*F,et=G-K*V,_t=N-tt*V,vt=$-K*ct,Pt=H-tt*ct,wt=vt*_t-Pt*et,$t=pt*Pt-ft*vt,le=et*ft-_t*pt;if(s){if(wt<0||$t<0||le<0)return null}else if((wt<0||$t<0||le<0)&&(wt>0||$t>0||le>0))return null;let Xt=wt+$t+le;if(Xt===0)return null;let me=nt*(wt*F+$t*V+le*ct);return(Xt>0?me<0:me>0)?null:this.at(me/Xt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ns=class extends es{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new he(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ms,this.combine=ef,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},im=new De,cr=new fr,Bl=new ur,sm=new X,kl=new X,zl=new X,Vl=new X,Bu=new X,Gl=new X,rm=new X,Hl=new X,Mn=class extends Un{constructor(t=new ln,e=new ns){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Gl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Bu.fromBufferAttribute(u,t),o?Gl.addScaledVector(Bu,h):Gl.addScaledVector(Bu.sub(e),h))}e.add(Gl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Bl.copy(n.boundingSphere),Bl.applyMatrix4(r),cr.copy(t.ray).recast(t.near),!(Bl.containsPoint(cr.origin)===!1&&(cr.intersectSphere(Bl,sm)===null||cr.origin.distanceToSquared(sm)>(t.far-t.near)**2))&&(im.copy(r).invert(),cr.copy(t.ray).applyMatrix4(im),!(n.boundingBox!==null&&cr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,cr)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,y=f.length;m<y;m++){let p=f[m],g=o[p.materialIndex],v=Math.max(p.start,d.start),C=Math.min(a.count,Math.min(p.start+p.count,d.start+d.count));for(let S=v,P=C;S<P;S+=3){let E=a.getX(S),_=a.getX(S+1),b=a.getX(S+2);s=Wl(this,g,t,n,c,h,u,E,_,b),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let m=Math.max(0,d.start),y=Math.min(a.count,d.start+d.count);for(let p=m,g=y;p<g;p+=3){let v=a.getX(p),C=a.getX(p+1),S=a.getX(p+2);s=Wl(this,o,t,n,c,h,u,v,C,S),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,y=f.length;m<y;m++){let p=f[m],g=o[p.materialIndex],v=Math.max(p.start,d.start),C=Math.min(l.count,Math.min(p.start+p.count,d.start+d.count));for(let S=v,P=C;S<P;S+=3){let E=S,_=S+1,b=S+2;s=Wl(this,g,t,n,c,h,u,E,_,b),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let m=Math.max(0,d.start),y=Math.min(l.count,d.start+d.count);for(let p=m,g=y;p<g;p+=3){let v=p,C=p+1,S=p+2;s=Wl(this,o,t,n,c,h,u,v,C,S),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function sv(i,t,e,n,s,r,o,a){let l;if(t.side===ti?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===Ys,a),l===null)return null;Hl.copy(a),Hl.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Hl);return c<e.near||c>e.far?null:{distance:c,point:Hl.clone(),object:i}}function Wl(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,kl),i.getVertexPosition(l,zl),i.getVertexPosition(c,Vl);let h=sv(i,t,e,n,kl,zl,Vl,rm);if(h){let u=new X;Qi.getBarycoord(rm,kl,zl,Vl,u),s&&(h.uv=Qi.getInterpolatedAttribute(s,a,l,c,u,new Zt)),r&&(h.uv1=Qi.getInterpolatedAttribute(r,a,l,c,u,new Zt)),o&&(h.normal=Qi.getInterpolatedAttribute(o,a,l,c,u,new X),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new X,materialIndex:0};Qi.getNormal(kl,zl,Vl,f.normal),h.face=f,h.barycoord=u}return h}var gc=class extends Qn{constructor(t=null,e=1,n=1,s,r,o,a,l,c=Nn,h=Nn,u,f){super(null,o,a,l,c,h,s,r,u,f),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var hr=new ur,rv=new Zt(.5,.5),Xl=new X,Gs=class{constructor(t=new di,e=new di,n=new di,s=new di,r=new di,o=new di){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=bi,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],f=r[6],d=r[7],m=r[8],y=r[9],p=r[10],g=r[11],v=r[12],C=r[13],S=r[14],P=r[15];if(s[0].setComponents(c-o,d-h,g-m,P-v).normalize(),s[1].setComponents(c+o,d+h,g+m,P+v).normalize(),s[2].setComponents(c+a,d+u,g+y,P+C).normalize(),s[3].setComponents(c-a,d-u,g-y,P-C).normalize(),n)s[4].setComponents(l,f,p,S).normalize(),s[5].setComponents(c-l,d-f,g-p,P-S).normalize();else if(s[4].setComponents(c-l,d-f,g-p,P-S).normalize(),e===bi)s[5].setComponents(c+l,d+f,g+p,P+S).normalize();else if(e===lo)s[5].setComponents(l,f,p,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),hr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),hr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(hr)}intersectsSprite(t){hr.center.set(0,0,0);let e=rv.distanceTo(t.center);return hr.radius=.7071067811865476+e,hr.applyMatrix4(t.matrixWorld),this.intersectsSphere(hr)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(Xl.x=s.normal.x>0?t.max.x:t.min.x,Xl.y=s.normal.y>0?t.max.y:t.min.y,Xl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Xl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},om=new De,_c=class i{constructor(){this.coordinateSystem=bi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];om.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Gs),n[s].setFromProjectionMatrix(om,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Gs),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var wi=class extends es{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new he(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},xc=new X,yc=new X,am=new De,ea=new fr,ql=new ur,ku=new X,lm=new X,mo=class extends Un{constructor(t=new ln,e=new wi){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)xc.fromBufferAttribute(e,s-1),yc.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=xc.distanceTo(yc);t.setAttribute("lineDistance",new Re(n,1))}else jt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),ql.copy(n.boundingSphere),ql.applyMatrix4(s),ql.radius+=r,t.ray.intersectsSphere(ql)===!1)return;am.copy(s).invert(),ea.copy(t.ray).applyMatrix4(am);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,f=n.attributes.position;if(h!==null){let d=Math.max(0,o.start),m=Math.min(h.count,o.start+o.count);for(let y=d,p=m-1;y<p;y+=c){let g=h.getX(y),v=h.getX(y+1),C=$l(this,t,ea,l,g,v,y);C&&e.push(C)}if(this.isLineLoop){let y=h.getX(m-1),p=h.getX(d),g=$l(this,t,ea,l,y,p,m-1);g&&e.push(g)}}else{let d=Math.max(0,o.start),m=Math.min(f.count,o.start+o.count);for(let y=d,p=m-1;y<p;y+=c){let g=$l(this,t,ea,l,y,y+1,y);g&&e.push(g)}if(this.isLineLoop){let y=$l(this,t,ea,l,m-1,d,m-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function $l(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(xc.fromBufferAttribute(a,s),yc.fromBufferAttribute(a,r),e.distanceSqToSegment(xc,yc,ku,lm)>n)return;ku.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(ku);if(!(c<t.near||c>t.far))return{distance:c,point:lm.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var cm=new X,hm=new X,is=class extends mo{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)cm.fromBufferAttribute(e,s),hm.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+cm.distanceTo(hm);t.setAttribute("lineDistance",new Re(n,1))}else jt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ga=class extends Qn{constructor(t=[],e=_r,n,s,r,o,a,l,c,h){super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},_a=class extends Qn{constructor(t,e,n,s,r,o,a,l,c){super(t,e,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var bs=class extends Qn{constructor(t,e,n=Fi,s,r,o,a=Nn,l=Nn,c,h=Ss,u=1){if(h!==Ss&&h!==Ts)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:u};super(f,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new uo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},xa=class extends bs{constructor(t,e=Fi,n=_r,s,r,o=Nn,a=Nn,l,c=Ss){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},ya=class extends Qn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},mi=class i extends ln{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],f=0,d=0;m("z","y","x",-1,-1,n,e,t,o,r,0),m("z","y","x",1,-1,n,e,-t,o,r,1),m("x","z","y",1,1,t,n,e,s,o,2),m("x","z","y",1,-1,t,n,-e,s,o,3),m("x","y","z",1,-1,t,e,n,s,r,4),m("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Re(c,3)),this.setAttribute("normal",new Re(h,3)),this.setAttribute("uv",new Re(u,2));function m(y,p,g,v,C,S,P,E,_,b,O){let D=S/_,A=P/b,F=S/2,G=P/2,N=E/2,V=_+1,$=b+1,H=0,ct=0,K=new X;for(let tt=0;tt<$;tt++){let nt=tt*A-G;for(let pt=0;pt<V;pt++){let ft=pt*D-F;K[y]=ft*v,K[p]=nt*C,K[g]=N,c.push(K.x,K.y,K.z),K[y]=0,K[p]=0,K[g]=E>0?1:-1,h.push(K.x,K.y,K.z),u.push(pt/_),u.push(1-tt/b),H+=1}}for(let tt=0;tt<b;tt++)for(let nt=0;nt<_;nt++){let pt=f+nt+V*tt,ft=f+nt+V*(tt+1),et=f+(nt+1)+V*(tt+1),_t=f+(nt+1)+V*tt;l.push(pt,ft,_t),l.push(ft,et,_t),ct+=6}a.addGroup(d,ct,O),d+=ct,f+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var dr=class i extends ln{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],f=[],d=[],m=0,y=[],p=n/2,g=0;v(),o===!1&&(t>0&&C(!0),e>0&&C(!1)),this.setIndex(h),this.setAttribute("position",new Re(u,3)),this.setAttribute("normal",new Re(f,3)),this.setAttribute("uv",new Re(d,2));function v(){let S=new X,P=new X,E=0,_=(e-t)/n;for(let b=0;b<=r;b++){let O=[],D=b/r,A=D*(e-t)+t;for(let F=0;F<=s;F++){let G=F/s,N=G*l+a,V=Math.sin(N),$=Math.cos(N);P.x=A*V,P.y=-D*n+p,P.z=A*$,u.push(P.x,P.y,P.z),S.set(V,_,$).normalize(),f.push(S.x,S.y,S.z),d.push(G,1-D),O.push(m++)}y.push(O)}for(let b=0;b<s;b++)for(let O=0;O<r;O++){let D=y[O][b],A=y[O+1][b],F=y[O+1][b+1],G=y[O][b+1];(t>0||O!==0)&&(h.push(D,A,G),E+=3),(e>0||O!==r-1)&&(h.push(A,F,G),E+=3)}c.addGroup(g,E,0),g+=E}function C(S){let P=m,E=new Zt,_=new X,b=0,O=S===!0?t:e,D=S===!0?1:-1;for(let F=1;F<=s;F++)u.push(0,p*D,0),f.push(0,D,0),d.push(.5,.5),m++;let A=m;for(let F=0;F<=s;F++){let N=F/s*l+a,V=Math.cos(N),$=Math.sin(N);_.x=O*$,_.y=p*D,_.z=O*V,u.push(_.x,_.y,_.z),f.push(0,D,0),E.x=V*.5+.5,E.y=$*.5*D+.5,d.push(E.x,E.y),m++}for(let F=0;F<s;F++){let G=P+F,N=A+F;S===!0?h.push(N,N+1,G):h.push(N+1,N,G),b+=3}c.addGroup(g,b,S===!0?1:2),g+=b}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var Yl=new X,Zl=new X,zu=new X,Jl=new Qi,va=class extends ln{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(ro*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),f=new Map,d=[];for(let m=0;m<l;m+=3){o?(c[0]=o.getX(m),c[1]=o.getX(m+1),c[2]=o.getX(m+2)):(c[0]=m,c[1]=m+1,c[2]=m+2);let{a:y,b:p,c:g}=Jl;if(y.fromBufferAttribute(a,c[0]),p.fromBufferAttribute(a,c[1]),g.fromBufferAttribute(a,c[2]),Jl.getNormal(zu),u[0]=`${Math.round(y.x*s)},${Math.round(y.y*s)},${Math.round(y.z*s)}`,u[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,u[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let v=0;v<3;v++){let C=(v+1)%3,S=u[v],P=u[C],E=Jl[h[v]],_=Jl[h[C]],b=`${S}_${P}`,O=`${P}_${S}`,D=f.get(O);D?(zu.dot(D.normal)<=r&&(d.push(E.x,E.y,E.z),d.push(_.x,_.y,_.z)),f.set(O,null)):f.has(b)||f.set(b,{index0:c[v],index1:c[C],normal:zu.clone()})}}for(let m of f.values())if(m){let{index0:y,index1:p}=m;Yl.fromBufferAttribute(a,y),Zl.fromBufferAttribute(a,p),d.push(Yl.x,Yl.y,Yl.z),d.push(Zl.x,Zl.y,Zl.z)}this.setAttribute("position",new Re(d,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var Sa=class i extends ln{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=t/a,f=e/l,d=[],m=[],y=[],p=[];for(let g=0;g<h;g++){let v=g*f-o;for(let C=0;C<c;C++){let S=C*u-r;m.push(S,-v,0),y.push(0,0,1),p.push(C/a),p.push(1-g/l)}}for(let g=0;g<l;g++)for(let v=0;v<a;v++){let C=v+c*g,S=v+c*(g+1),P=v+1+c*(g+1),E=v+1+c*g;d.push(C,S,E),d.push(S,P,E)}this.setIndex(d),this.setAttribute("position",new Re(m,3)),this.setAttribute("normal",new Re(y,3)),this.setAttribute("uv",new Re(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}},Ma=class i extends ln{constructor(t=.5,e=1,n=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:t,outerRadius:e,thetaSegments:n,phiSegments:s,thetaStart:r,thetaLength:o},n=Math.max(3,n),s=Math.max(1,s);let a=[],l=[],c=[],h=[],u=t,f=(e-t)/s,d=new X,m=new Zt;for(let y=0;y<=s;y++){for(let p=0;p<=n;p++){let g=r+p/n*o;d.x=u*Math.cos(g),d.y=u*Math.sin(g),l.push(d.x,d.y,d.z),c.push(0,0,1),m.x=(d.x/e+1)/2,m.y=(d.y/e+1)/2,h.push(m.x,m.y)}u+=f}for(let y=0;y<s;y++){let p=y*(n+1);for(let g=0;g<n;g++){let v=g+p,C=v,S=v+n+1,P=v+n+2,E=v+1;a.push(C,S,E),a.push(S,P,E)}}this.setIndex(a),this.setAttribute("position",new Re(l,3)),this.setAttribute("normal",new Re(c,3)),this.setAttribute("uv",new Re(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.innerRadius,t.outerRadius,t.thetaSegments,t.phiSegments,t.thetaStart,t.thetaLength)}};var pr=class i extends ln{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new X,f=new X,d=[],m=[],y=[],p=[];for(let g=0;g<=n;g++){let v=[],C=g/n,S=o+C*a,P=t*Math.cos(S),E=Math.sqrt(t*t-P*P),_=0;g===0&&o===0?_=.5/e:g===n&&l===Math.PI&&(_=-.5/e);for(let b=0;b<=e;b++){let O=b/e,D=s+O*r;u.x=-E*Math.cos(D),u.y=P,u.z=E*Math.sin(D),m.push(u.x,u.y,u.z),f.copy(u).normalize(),y.push(f.x,f.y,f.z),p.push(O+_,1-C),v.push(c++)}h.push(v)}for(let g=0;g<n;g++)for(let v=0;v<e;v++){let C=h[g][v+1],S=h[g][v],P=h[g+1][v],E=h[g+1][v+1];(g!==0||o>0)&&d.push(C,S,E),(g!==n-1||l<Math.PI)&&d.push(S,P,E)}this.setIndex(d),this.setAttribute("position",new Re(m,3)),this.setAttribute("normal",new Re(y,3)),this.setAttribute("uv",new Re(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function yr(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(um(s))s.isRenderTargetTexture?(jt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(um(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Gn(i){let t={};for(let e=0;e<i.length;e++){let n=yr(i[e]);for(let s in n)t[s]=n[s]}return t}function um(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function ov(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Cf(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Se.workingColorSpace}var ng={clone:yr,merge:Gn},av=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,lv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ss=class extends es{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=av,this.fragmentShader=lv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=yr(t.uniforms),this.uniformsGroups=ov(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new he().setHex(s.value);break;case"v2":this.uniforms[n].value=new Zt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new X().fromArray(s.value);break;case"v4":this.uniforms[n].value=new je().fromArray(s.value);break;case"m3":this.uniforms[n].value=new re().fromArray(s.value);break;case"m4":this.uniforms[n].value=new De().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},vc=class extends ss{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},rs=class extends es{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new he(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new he(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=vh,this.normalScale=new Zt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ms,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var Sc=class extends es{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Gm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Mc=class extends es{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};var ba=class extends wi{constructor(t){super(),this.isLineDashedMaterial=!0,this.type="LineDashedMaterial",this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(t)}copy(t){return super.copy(t),this.scale=t.scale,this.dashSize=t.dashSize,this.gapSize=t.gapSize,this}};function no(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function Kl(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Hs=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},bc=class extends Hs{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Hu,endingEnd:Hu}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Wu:r=t,a=2*e-n;break;case Xu:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Wu:o=t,l=2*n-e;break;case Xu:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,f=this._weightPrev,d=this._weightNext,m=(n-e)/(s-e),y=m*m,p=y*m,g=-f*p+2*f*y-f*m,v=(1+f)*p+(-1.5-2*f)*y+(-.5+f)*m+1,C=(-1-d)*p+(1.5+d)*y+.5*m,S=d*p-d*y;for(let P=0;P!==a;++P)r[P]=g*o[h+P]+v*o[c+P]+C*o[l+P]+S*o[u+P];return r}},wc=class extends Hs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),u=1-h;for(let f=0;f!==a;++f)r[f]=o[c+f]*u+o[l+f]*h;return r}},Tc=class extends Hs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Ec=class extends Hs{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let m=(n-e)/(s-e),y=1-m;for(let p=0;p!==a;++p)r[p]=o[c+p]*y+o[l+p]*m;return r}let f=a*2,d=t-1;for(let m=0;m!==a;++m){let y=o[c+m],p=o[l+m],g=d*f+m*2,v=u[g],C=u[g+1],S=t*f+m*2,P=h[S],E=h[S+1],_=hv(n,e,v,P,s);r[m]=ig(_,y,C,E,p)}return r}};function ig(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function cv(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function hv(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=ig(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=cv(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var gi=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=no(e,this.TimeBufferType),this.values=no(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:no(t.times,Array),values:no(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),Kl(t.settings)&&(n.settings={inTangents:no(t.settings.inTangents,Array),outTangents:no(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Tc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new wc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new bc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Ec(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case sa:e=this.InterpolantFactoryMethodDiscrete;break;case uc:e=this.InterpolantFactoryMethodLinear;break;case tc:e=this.InterpolantFactoryMethodSmooth;break;case Gu:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return jt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return sa;case this.InterpolantFactoryMethodLinear:return uc;case this.InterpolantFactoryMethodSmooth:return tc;case this.InterpolantFactoryMethodBezier:return Gu}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;Kl(this.settings)&&(fm(this.settings.inTangents,t),fm(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;Kl(this.settings)&&(dm(this.settings.inTangents,t),dm(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ie("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ie("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){ie("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ie("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Ey(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ie("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===tc,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*n,f=u-n,d=u+n;for(let m=0;m!==n;++m){let y=e[u+m];if(y!==e[f+m]||y!==e[d+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*n,f=o*n;for(let d=0;d!==n;++d)e[f+d]=e[u+d]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,Kl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function fm(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function dm(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}gi.prototype.ValueTypeName="";gi.prototype.TimeBufferType=Float32Array;gi.prototype.ValueBufferType=Float32Array;gi.prototype.DefaultInterpolation=uc;var Ws=class extends gi{constructor(t,e,n){super(t,e,n)}};Ws.prototype.ValueTypeName="bool";Ws.prototype.ValueBufferType=Array;Ws.prototype.DefaultInterpolation=sa;Ws.prototype.InterpolantFactoryMethodLinear=void 0;Ws.prototype.InterpolantFactoryMethodSmooth=void 0;var Ac=class extends gi{constructor(t,e,n,s){super(t,e,n,s)}};Ac.prototype.ValueTypeName="color";var Cc=class extends gi{constructor(t,e,n,s){super(t,e,n,s)}};Cc.prototype.ValueTypeName="number";var Rc=class extends Hs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)jn.slerpFlat(r,0,o,c-a,o,c,l);return r}},wa=class extends gi{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new Rc(this.times,this.values,this.getValueSize(),t)}};wa.prototype.ValueTypeName="quaternion";wa.prototype.InterpolantFactoryMethodSmooth=void 0;var Xs=class extends gi{constructor(t,e,n){super(t,e,n)}};Xs.prototype.ValueTypeName="string";Xs.prototype.ValueBufferType=Array;Xs.prototype.DefaultInterpolation=sa;Xs.prototype.InterpolantFactoryMethodLinear=void 0;Xs.prototype.InterpolantFactoryMethodSmooth=void 0;var Pc=class extends gi{constructor(t,e,n,s){super(t,e,n,s)}};Pc.prototype.ValueTypeName="vector";var Ic=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,f=c.length;u<f;u+=2){let d=c[u],m=c[u+1];if(d.global&&(d.lastIndex=0),d.test(h))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},sg=new Ic,Lc=class{constructor(t){this.manager=t!==void 0?t:sg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Lc.DEFAULT_MATERIAL_NAME="__DEFAULT";var go=class extends Un{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new he(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},Ta=class extends go{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Un.DEFAULT_UP),this.updateMatrix(),this.groundColor=new he(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},Vu=new De,pm=new X,mm=new X,Dc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Zt(512,512),this.mapType=ri,this.map=null,this.mapPass=null,this.matrix=new De,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Gs,this._frameExtents=new Zt(1,1),this._viewportCount=1,this._viewports=[new je(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;pm.setFromMatrixPosition(t.matrixWorld),e.position.copy(pm),mm.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(mm),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){Vu.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(Vu,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===lo||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(Vu)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},jl=new X,Ql=new jn,ji=new X,Ea=class extends Un{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new De,this.projectionMatrix=new De,this.projectionMatrixInverse=new De,this.coordinateSystem=bi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(jl,Ql,ji),ji.x===1&&ji.y===1&&ji.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(jl,Ql,ji.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(jl,Ql,ji),ji.x===1&&ji.y===1&&ji.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(jl,Ql,ji.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},zs=new X,gm=new Zt,_m=new Zt,Jn=class extends Ea{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=ho*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(ro*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return ho*2*Math.atan(Math.tan(ro*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){zs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(zs.x,zs.y).multiplyScalar(-t/zs.z),zs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(zs.x,zs.y).multiplyScalar(-t/zs.z)}getViewSize(t,e){return this.getViewBounds(t,gm,_m),e.subVectors(_m,gm)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(ro*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Aa=class extends Ea{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},qu=class extends Dc{constructor(){super(new Aa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ca=class extends go{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Un.DEFAULT_UP),this.updateMatrix(),this.target=new Un,this.shadow=new qu}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},Ra=class extends go{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var io=-90,so=1,_o=class extends Un{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Jn(io,so,t,e);s.layers=this.layers,this.add(s);let r=new Jn(io,so,t,e);r.layers=this.layers,this.add(r);let o=new Jn(io,so,t,e);o.layers=this.layers,this.add(o);let a=new Jn(io,so,t,e);a.layers=this.layers,this.add(a);let l=new Jn(io,so,t,e);l.layers=this.layers,this.add(l);let c=new Jn(io,so,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===bi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===lo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=y,t.setRenderTarget(n,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,f,d),t.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},Nc=class extends Jn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Rf="\\[\\]\\.:\\/",uv=new RegExp("["+Rf+"]","g"),Pf="[^"+Rf+"]",fv="[^"+Rf.replace("\\.","")+"]",dv=/((?:WC+[\/:])*)/.source.replace("WC",Pf),pv=/(WCOD+)?/.source.replace("WCOD",fv),mv=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Pf),gv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Pf),_v=new RegExp("^"+dv+pv+mv+gv+"$"),xv=["material","materials","bones","map"],$u=class{constructor(t,e,n){let s=n||Ye.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Ye=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(uv,"")}static parseTrackName(t){let e=_v.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);xv.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){jt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){ie("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ie("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ie("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ie("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ie("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){ie("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){ie("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ie("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ie("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ie("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ye.Composite=$u;Ye.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ye.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ye.prototype.GetterByBindingType=[Ye.prototype._getValue_direct,Ye.prototype._getValue_array,Ye.prototype._getValue_arrayElement,Ye.prototype._getValue_toArray];Ye.prototype.SetterByBindingTypeAndVersioning=[[Ye.prototype._setValue_direct,Ye.prototype._setValue_direct_setNeedsUpdate,Ye.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_array,Ye.prototype._setValue_array_setNeedsUpdate,Ye.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_arrayElement,Ye.prototype._setValue_arrayElement_setNeedsUpdate,Ye.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_fromArray,Ye.prototype._setValue_fromArray_setNeedsUpdate,Ye.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var nP=new Float32Array(1);var xo=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=xe(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(xe(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Yu=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var Pa=class extends is{constructor(t=10,e=10,n=4473924,s=8947848){n=new he(n),s=new he(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let f=0,d=0,m=-a;f<=e;f++,m+=o){l.push(-a,0,m,a,0,m),l.push(m,0,-a,m,0,a);let y=f===r?n:s;y.toArray(c,d),d+=3,y.toArray(c,d),d+=3,y.toArray(c,d),d+=3,y.toArray(c,d),d+=3}let h=new ln;h.setAttribute("position",new Re(l,3)),h.setAttribute("color",new Re(c,3));let u=new wi({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Ia=class extends Ui{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function If(i,t,e,n){let s=yv(n);switch(e){case mf:return i*t;case _f:return i*t/s.components*s.byteLength;case Vc:return i*t/s.components*s.byteLength;case Zs:return i*t*2/s.components*s.byteLength;case Gc:return i*t*2/s.components*s.byteLength;case gf:return i*t*3/s.components*s.byteLength;case ki:return i*t*4/s.components*s.byteLength;case Hc:return i*t*4/s.components*s.byteLength;case Na:case Ua:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Fa:case Oa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Xc:case $c:return Math.max(i,16)*Math.max(t,8)/4;case Wc:case qc:return Math.max(i,8)*Math.max(t,8)/2;case Yc:case Zc:case Kc:case jc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Jc:case Ba:case Qc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case th:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case eh:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case nh:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case ih:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case sh:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case rh:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case oh:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case ah:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case lh:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case ch:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case hh:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case uh:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case fh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case dh:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case ph:case mh:case gh:return Math.ceil(i/4)*Math.ceil(t/4)*16;case _h:case xh:return Math.ceil(i/4)*Math.ceil(t/4)*8;case ka:case yh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function yv(i){switch(i){case ri:case uf:return{byteLength:1,components:1};case Mo:case ff:case Bi:return{byteLength:2,components:1};case kc:case zc:return{byteLength:2,components:4};case Fi:case Bc:case Oi:return{byteLength:4,components:1};case df:case pf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?jt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Eg(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function Sv(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,h),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((d,m)=>d.start-m.start);let f=0;for(let d=1;d<u.length;d++){let m=u[f],y=u[d];y.start<=m.start+m.count+1?m.count=Math.max(m.count,y.start+y.count-m.start):(++f,u[f]=y)}u.length=f+1;for(let d=0,m=u.length;d<m;d++){let y=u[d];i.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Mv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,bv=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,wv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Tv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ev=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Av=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Cv=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Rv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Pv=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Iv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Lv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Dv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Nv=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Uv=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Fv=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Ov=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Bv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,kv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,zv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Vv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Gv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Hv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Wv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Xv=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,qv=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,$v=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Yv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Zv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Jv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Kv="gl_FragColor = linearToOutputTexel( gl_FragColor );",jv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Qv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,tS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,eS=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,nS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,iS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,sS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,rS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,oS=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,aS=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,lS=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,cS=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,hS=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,uS=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,fS=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,dS=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,pS=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,mS=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,gS=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,_S=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,xS=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,yS=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,vS=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,SS=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,MS=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,bS=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,wS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,TS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ES=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,AS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,CS=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,RS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,PS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,IS=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,LS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,DS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,NS=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,US=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,FS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,OS=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,BS=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,kS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,zS=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,VS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,GS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,HS=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,WS=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,XS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,qS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,$S=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,YS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,ZS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,JS=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,KS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,jS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,QS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,tM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,eM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,nM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,iM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,sM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,rM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,oM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,aM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,lM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,cM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,hM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,uM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,fM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,dM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,pM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,mM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,gM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,_M=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,xM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,yM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,vM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,SM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,MM=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,bM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,wM=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,TM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,EM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,AM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,CM=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,RM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,PM=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,IM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,LM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,DM=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,NM=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,UM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,FM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,OM=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,BM=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,kM=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,zM=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,VM=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,GM=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,HM=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,WM=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,XM=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,qM=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,$M=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,YM=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ZM=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,JM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,KM=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,jM=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,QM=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,tb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,pe={alphahash_fragment:Mv,alphahash_pars_fragment:bv,alphamap_fragment:wv,alphamap_pars_fragment:Tv,alphatest_fragment:Ev,alphatest_pars_fragment:Av,aomap_fragment:Cv,aomap_pars_fragment:Rv,batching_pars_vertex:Pv,batching_vertex:Iv,begin_vertex:Lv,beginnormal_vertex:Dv,bsdfs:Nv,iridescence_fragment:Uv,bumpmap_pars_fragment:Fv,clipping_planes_fragment:Ov,clipping_planes_pars_fragment:Bv,clipping_planes_pars_vertex:kv,clipping_planes_vertex:zv,color_fragment:Vv,color_pars_fragment:Gv,color_pars_vertex:Hv,color_vertex:Wv,common:Xv,defaultnormal_vertex:qv,displacementmap_pars_vertex:$v,displacementmap_vertex:Yv,emissivemap_fragment:Zv,emissivemap_pars_fragment:Jv,colorspace_fragment:Kv,colorspace_pars_fragment:jv,envmap_fragment:Qv,envmap_common_pars_fragment:tS,envmap_pars_fragment:eS,envmap_pars_vertex:nS,envmap_physical_pars_fragment:dS,envmap_vertex:iS,fog_vertex:sS,fog_pars_vertex:rS,fog_fragment:oS,fog_pars_fragment:aS,gradientmap_pars_fragment:lS,lightmap_pars_fragment:cS,lights_lambert_fragment:hS,lights_lambert_pars_fragment:uS,lights_pars_begin:fS,lights_toon_fragment:pS,lights_toon_pars_fragment:mS,lights_phong_fragment:gS,lights_phong_pars_fragment:_S,lights_physical_fragment:xS,lights_physical_pars_fragment:yS,lights_fragment_begin:vS,lights_fragment_maps:SS,lights_fragment_end:MS,lightprobes_pars_fragment:bS,logdepthbuf_fragment:wS,logdepthbuf_pars_fragment:TS,logdepthbuf_pars_vertex:ES,logdepthbuf_vertex:AS,map_fragment:CS,map_pars_fragment:RS,map_particle_fragment:PS,map_particle_pars_fragment:IS,metalnessmap_fragment:LS,metalnessmap_pars_fragment:DS,morphinstance_vertex:NS,morphcolor_vertex:US,morphnormal_vertex:FS,morphtarget_pars_vertex:OS,morphtarget_vertex:BS,normal_fragment_begin:kS,normal_fragment_maps:zS,normal_pars_fragment:VS,normal_pars_vertex:GS,normal_vertex:HS,normalmap_pars_fragment:WS,clearcoat_normal_fragment_begin:XS,clearcoat_normal_fragment_maps:qS,clearcoat_pars_fragment:$S,iridescence_pars_fragment:YS,opaque_fragment:ZS,packing:JS,premultiplied_alpha_fragment:KS,project_vertex:jS,dithering_fragment:QS,dithering_pars_fragment:tM,roughnessmap_fragment:eM,roughnessmap_pars_fragment:nM,shadowmap_pars_fragment:iM,shadowmap_pars_vertex:sM,shadowmap_vertex:rM,shadowmask_pars_fragment:oM,skinbase_vertex:aM,skinning_pars_vertex:lM,skinning_vertex:cM,skinnormal_vertex:hM,specularmap_fragment:uM,specularmap_pars_fragment:fM,tonemapping_fragment:dM,tonemapping_pars_fragment:pM,transmission_fragment:mM,transmission_pars_fragment:gM,uv_pars_fragment:_M,uv_pars_vertex:xM,uv_vertex:yM,worldpos_vertex:vM,background_vert:SM,background_frag:MM,backgroundCube_vert:bM,backgroundCube_frag:wM,cube_vert:TM,cube_frag:EM,depth_vert:AM,depth_frag:CM,distance_vert:RM,distance_frag:PM,equirect_vert:IM,equirect_frag:LM,linedashed_vert:DM,linedashed_frag:NM,meshbasic_vert:UM,meshbasic_frag:FM,meshlambert_vert:OM,meshlambert_frag:BM,meshmatcap_vert:kM,meshmatcap_frag:zM,meshnormal_vert:VM,meshnormal_frag:GM,meshphong_vert:HM,meshphong_frag:WM,meshphysical_vert:XM,meshphysical_frag:qM,meshtoon_vert:$M,meshtoon_frag:YM,points_vert:ZM,points_frag:JM,shadow_vert:KM,shadow_frag:jM,sprite_vert:QM,sprite_frag:tb},Ut={common:{diffuse:{value:new he(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new re},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new re}},envmap:{envMap:{value:null},envMapRotation:{value:new re},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new re}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new re}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new re},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new re},normalScale:{value:new Zt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new re},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new re}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new re}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new re}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new he(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new he(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0},uvTransform:{value:new re}},sprite:{diffuse:{value:new he(16777215)},opacity:{value:1},center:{value:new Zt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new re},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0}}},ls={basic:{uniforms:Gn([Ut.common,Ut.specularmap,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.fog]),vertexShader:pe.meshbasic_vert,fragmentShader:pe.meshbasic_frag},lambert:{uniforms:Gn([Ut.common,Ut.specularmap,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.fog,Ut.lights,{emissive:{value:new he(0)},envMapIntensity:{value:1}}]),vertexShader:pe.meshlambert_vert,fragmentShader:pe.meshlambert_frag},phong:{uniforms:Gn([Ut.common,Ut.specularmap,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.fog,Ut.lights,{emissive:{value:new he(0)},specular:{value:new he(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:pe.meshphong_vert,fragmentShader:pe.meshphong_frag},standard:{uniforms:Gn([Ut.common,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.roughnessmap,Ut.metalnessmap,Ut.fog,Ut.lights,{emissive:{value:new he(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:pe.meshphysical_vert,fragmentShader:pe.meshphysical_frag},toon:{uniforms:Gn([Ut.common,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.gradientmap,Ut.fog,Ut.lights,{emissive:{value:new he(0)}}]),vertexShader:pe.meshtoon_vert,fragmentShader:pe.meshtoon_frag},matcap:{uniforms:Gn([Ut.common,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.fog,{matcap:{value:null}}]),vertexShader:pe.meshmatcap_vert,fragmentShader:pe.meshmatcap_frag},points:{uniforms:Gn([Ut.points,Ut.fog]),vertexShader:pe.points_vert,fragmentShader:pe.points_frag},dashed:{uniforms:Gn([Ut.common,Ut.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:pe.linedashed_vert,fragmentShader:pe.linedashed_frag},depth:{uniforms:Gn([Ut.common,Ut.displacementmap]),vertexShader:pe.depth_vert,fragmentShader:pe.depth_frag},normal:{uniforms:Gn([Ut.common,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,{opacity:{value:1}}]),vertexShader:pe.meshnormal_vert,fragmentShader:pe.meshnormal_frag},sprite:{uniforms:Gn([Ut.sprite,Ut.fog]),vertexShader:pe.sprite_vert,fragmentShader:pe.sprite_frag},background:{uniforms:{uvTransform:{value:new re},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:pe.background_vert,fragmentShader:pe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new re}},vertexShader:pe.backgroundCube_vert,fragmentShader:pe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:pe.cube_vert,fragmentShader:pe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:pe.equirect_vert,fragmentShader:pe.equirect_frag},distance:{uniforms:Gn([Ut.common,Ut.displacementmap,{referencePosition:{value:new X},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:pe.distance_vert,fragmentShader:pe.distance_frag},shadow:{uniforms:Gn([Ut.lights,Ut.fog,{color:{value:new he(0)},opacity:{value:1}}]),vertexShader:pe.shadow_vert,fragmentShader:pe.shadow_frag}};ls.physical={uniforms:Gn([ls.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new re},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new re},clearcoatNormalScale:{value:new Zt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new re},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new re},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new re},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new re},sheen:{value:0},sheenColor:{value:new he(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new re},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new re},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new re},transmissionSamplerSize:{value:new Zt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new re},attenuationDistance:{value:0},attenuationColor:{value:new he(0)},specularColor:{value:new he(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new re},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new re},anisotropyVector:{value:new Zt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new re}}]),vertexShader:pe.meshphysical_vert,fragmentShader:pe.meshphysical_frag};var Mh={r:0,b:0,g:0},eb=new De,Ag=new re;Ag.set(-1,0,0,0,1,0,0,0,1);function nb(i,t,e,n,s,r){let o=new he(0),a=s===!0?0:1,l,c,h=null,u=0,f=null;function d(v){let C=v.isScene===!0?v.background:null;if(C&&C.isTexture){let S=v.backgroundBlurriness>0;C=t.get(C,S)}return C}function m(v){let C=!1,S=d(v);S===null?p(o,a):S&&S.isColor&&(p(S,1),C=!0);let P=i.xr.getEnvironmentBlendMode();P==="additive"?e.buffers.color.setClear(0,0,0,1,r):P==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||C)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(v,C){let S=d(C);S&&S.isCubeTexture?(c===void 0&&(c=new Mn(new mi(1,1,1),new ss({name:"BackgroundCubeMaterial",uniforms:yr(ls.backgroundCube.uniforms),vertexShader:ls.backgroundCube.vertexShader,fragmentShader:ls.backgroundCube.fragmentShader,side:ti,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(P,E,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(eb.makeRotationFromEuler(C.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Ag),c.material.toneMapped=Se.getTransfer(S.colorSpace)!==Le,(h!==S||u!==S.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,h=S,u=S.version,f=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Mn(new Sa(2,2),new ss({name:"BackgroundMaterial",uniforms:yr(ls.background.uniforms),vertexShader:ls.background.vertexShader,fragmentShader:ls.background.fragmentShader,side:Ys,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=Se.getTransfer(S.colorSpace)!==Le,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(h!==S||u!==S.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,h=S,u=S.version,f=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function p(v,C){v.getRGB(Mh,Cf(i)),e.buffers.color.setClear(Mh.r,Mh.g,Mh.b,C,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,C=1){o.set(v),a=C,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,p(o,a)},render:m,addToRenderList:y,dispose:g}}function ib(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(A,F,G,N,V){let $=!1,H=u(A,N,G,F);r!==H&&(r=H,c(r.object)),$=d(A,N,G,V),$&&m(A,N,G,V),V!==null&&t.update(V,i.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,S(A,F,G,N),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return i.createVertexArray()}function c(A){return i.bindVertexArray(A)}function h(A){return i.deleteVertexArray(A)}function u(A,F,G,N){let V=N.wireframe===!0,$=n[F.id];$===void 0&&($={},n[F.id]=$);let H=A.isInstancedMesh===!0?A.id:0,ct=$[H];ct===void 0&&(ct={},$[H]=ct);let K=ct[G.id];K===void 0&&(K={},ct[G.id]=K);let tt=K[V];return tt===void 0&&(tt=f(l()),K[V]=tt),tt}function f(A){let F=[],G=[],N=[];for(let V=0;V<e;V++)F[V]=0,G[V]=0,N[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:F,enabledAttributes:G,attributeDivisors:N,object:A,attributes:{},index:null}}function d(A,F,G,N){let V=r.attributes,$=F.attributes,H=0,ct=G.getAttributes();for(let K in ct)if(ct[K].location>=0){let nt=V[K],pt=$[K];if(pt===void 0&&(K==="instanceMatrix"&&A.instanceMatrix&&(pt=A.instanceMatrix),K==="instanceColor"&&A.instanceColor&&(pt=A.instanceColor)),nt===void 0||nt.attribute!==pt||pt&&nt.data!==pt.data)return!0;H++}return r.attributesNum!==H||r.index!==N}function m(A,F,G,N){let V={},$=F.attributes,H=0,ct=G.getAttributes();for(let K in ct)if(ct[K].location>=0){let nt=$[K];nt===void 0&&(K==="instanceMatrix"&&A.instanceMatrix&&(nt=A.instanceMatrix),K==="instanceColor"&&A.instanceColor&&(nt=A.instanceColor));let pt={};pt.attribute=nt,nt&&nt.data&&(pt.data=nt.data),V[K]=pt,H++}r.attributes=V,r.attributesNum=H,r.index=N}function y(){let A=r.newAttributes;for(let F=0,G=A.length;F<G;F++)A[F]=0}function p(A){g(A,0)}function g(A,F){let G=r.newAttributes,N=r.enabledAttributes,V=r.attributeDivisors;G[A]=1,N[A]===0&&(i.enableVertexAttribArray(A),N[A]=1),V[A]!==F&&(i.vertexAttribDivisor(A,F),V[A]=F)}function v(){let A=r.newAttributes,F=r.enabledAttributes;for(let G=0,N=F.length;G<N;G++)F[G]!==A[G]&&(i.disableVertexAttribArray(G),F[G]=0)}function C(A,F,G,N,V,$,H){H===!0?i.vertexAttribIPointer(A,F,G,V,$):i.vertexAttribPointer(A,F,G,N,V,$)}function S(A,F,G,N){y();let V=N.attributes,$=G.getAttributes(),H=F.defaultAttributeValues;for(let ct in $){let K=$[ct];if(K.location>=0){let tt=V[ct];if(tt===void 0&&(ct==="instanceMatrix"&&A.instanceMatrix&&(tt=A.instanceMatrix),ct==="instanceColor"&&A.instanceColor&&(tt=A.instanceColor)),tt!==void 0){let nt=tt.normalized,pt=tt.itemSize,ft=t.get(tt);if(ft===void 0)continue;let et=ft.buffer,_t=ft.type,vt=ft.bytesPerElement,Pt=_t===i.INT||_t===i.UNSIGNED_INT||tt.gpuType===Bc;if(tt.isInterleavedBufferAttribute){let wt=tt.data,$t=wt.isInterleavedBuffer===!0?wt.stride:wt.itemSize,le=tt.offset;if(wt.isInstancedInterleavedBuffer||wt.isInstancedBufferAttribute){for(let Xt=0;Xt<K.locationSize;Xt++)g(K.location+Xt,wt.meshPerAttribute);A.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=wt.meshPerAttribute*wt.count)}else for(let Xt=0;Xt<K.locationSize;Xt++)p(K.location+Xt);i.bindBuffer(i.ARRAY_BUFFER,et);for(let Xt=0;Xt<K.locationSize;Xt++)C(K.location+Xt,pt/K.locationSize,_t,nt,$t*vt,(le+pt/K.locationSize*Xt)*vt,Pt)}else{if(tt.isInstancedBufferAttribute){for(let wt=0;wt<K.locationSize;wt++)g(K.location+wt,tt.meshPerAttribute);A.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=tt.meshPerAttribute*tt.count)}else for(let wt=0;wt<K.locationSize;wt++)p(K.location+wt);i.bindBuffer(i.ARRAY_BUFFER,et);for(let wt=0;wt<K.locationSize;wt++)C(K.location+wt,pt/K.locationSize,_t,nt,pt*vt,pt/K.locationSize*wt*vt,Pt)}}else if(H!==void 0){let nt=H[ct];if(nt!==void 0)switch(nt.length){case 2:i.vertexAttrib2fv(K.location,nt);break;case 3:i.vertexAttrib3fv(K.location,nt);break;case 4:i.vertexAttrib4fv(K.location,nt);break;default:i.vertexAttrib1fv(K.location,nt)}}}}v()}function P(){O();for(let A in n){let F=n[A];for(let G in F){let N=F[G];for(let V in N){let $=N[V];for(let H in $)h($[H].object),delete $[H];delete N[V]}}delete n[A]}}function E(A){if(n[A.id]===void 0)return;let F=n[A.id];for(let G in F){let N=F[G];for(let V in N){let $=N[V];for(let H in $)h($[H].object),delete $[H];delete N[V]}}delete n[A.id]}function _(A){for(let F in n){let G=n[F];for(let N in G){let V=G[N];if(V[A.id]===void 0)continue;let $=V[A.id];for(let H in $)h($[H].object),delete $[H];delete V[A.id]}}}function b(A){for(let F in n){let G=n[F],N=A.isInstancedMesh===!0?A.id:0,V=G[N];if(V!==void 0){for(let $ in V){let H=V[$];for(let ct in H)h(H[ct].object),delete H[ct];delete V[$]}delete G[N],Object.keys(G).length===0&&delete n[F]}}}function O(){D(),o=!0,r!==s&&(r=s,c(r.object))}function D(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:O,resetDefaultState:D,dispose:P,releaseStatesOfGeometry:E,releaseStatesOfObject:b,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:p,disableUnusedAttributes:v}}function sb(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let f=0;for(let d=0;d<h;d++)f+=c[d];e.update(f,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function rb(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==ki&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let b=_===Bi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==ri&&_!==Oi&&!b&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(jt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),f=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&jt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&jt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),C=i.getParameter(i.MAX_VARYING_VECTORS),S=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),P=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:u,maxTextures:d,maxVertexTextures:m,maxTextureSize:y,maxCubemapSize:p,maxAttributes:g,maxVertexUniforms:v,maxVaryings:C,maxFragmentUniforms:S,maxSamples:P,samples:E}}function ob(i){let t=this,e=null,n=0,s=!1,r=!1,o=new di,a=new re,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let d=u.length!==0||f||n!==0||s;return s=f,n=u.length,d},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){e=h(u,f,0)},this.setState=function(u,f,d){let m=u.clippingPlanes,y=u.clipIntersection,p=u.clipShadows,g=i.get(u);if(!s||m===null||m.length===0||r&&!p)r?h(null):c();else{let v=r?0:n,C=v*4,S=g.clippingState||null;l.value=S,S=h(m,f,C,d);for(let P=0;P!==C;++P)S[P]=e[P];g.clippingState=S,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,f,d,m){let y=u!==null?u.length:0,p=null;if(y!==0){if(p=l.value,m!==!0||p===null){let g=d+y*4,v=f.matrixWorldInverse;a.getNormalMatrix(v),(p===null||p.length<g)&&(p=new Float32Array(g));for(let C=0,S=d;C!==y;++C,S+=4)o.copy(u[C]).applyMatrix4(v,a),o.normal.toArray(p,S),p[S+3]=o.constant}l.value=p,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,p}}var Ga=class extends pi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new ga(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new mi(5,5,5),r=new ss({name:"CubemapFromEquirect",uniforms:yr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ti,blending:mr});r.uniforms.tEquirect.value=e;let o=new Mn(s,r),a=e.minFilter;return e.minFilter===ws&&(e.minFilter=Kn),new _o(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},rg=256,ab=3,lb=20,Cg=256,Rg=16,cb=3,hb=new X,ub=new he,wh=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new _o(1,10,null),this._boxMesh=new Mn(new mi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=hb}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,m=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(ub));let p=new _o(n,s,h);return p.position.copy(a),p.update(l,t),l.autoClear=u,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=m,t.background=y,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=lg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=ag(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(rg,wf(t))}_fromTexture(t,e){t.mapping===_r||t.mapping===So?this._setSize(t.image.length===0?rg:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=og(t,!1,!1),n=Math.log2(t)-ab;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=og(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===_r||t.mapping===So?(this._cubemapMaterial===null&&(this._cubemapMaterial=lg()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=ag()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=fb(),this._integrationMaterial=db());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Rg);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-cb)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Cg*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=pb());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function og(i,t,e){return new Ga(i,{minFilter:ws,generateMipmaps:t,type:Bi,colorSpace:ra,depthBuffer:e})}function Ha(i,t,e){return new ss({name:i,uniforms:t,vertexShader:pe.cube_vert,fragmentShader:e,side:ti,blending:mr,depthTest:!1,depthWrite:!1})}function fb(){return Ha("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Cg}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function db(){return Ha("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Rg}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function pb(){return Ha("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${lb}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function ag(){return Ha("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function lg(){return Ha("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function mb(i){let t=new WeakMap,e=new WeakMap,n=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===Uc||d===Fc)if(t.has(f)){let m=t.get(f).texture;return a(m,f.mapping)}else{let m=f.image;if(m&&m.height>0){let y=new Ga(m.height);return y.fromEquirectangularTexture(i,f),t.set(f,y),f.addEventListener("dispose",c),a(y.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,m=d===Uc||d===Fc,y=d===_r||d===So;if(m||y){let p=e.get(f),g=p!==void 0?p.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==g)return n===null&&(n=new wh(i)),p=m?n.fromEquirectangular(f,p):n.fromCubemap(f,p),p.texture.pmremVersion=f.pmremVersion,e.set(f,p),p.texture;if(p!==void 0)return p.texture;{let v=f.image;return m&&v&&v.height>0||y&&v&&l(v)?(n===null&&(n=new wh(i)),p=m?n.fromEquirectangular(f):n.fromCubemap(f),p.texture.pmremVersion=f.pmremVersion,e.set(f,p),f.addEventListener("dispose",h),p.texture):null}}}return f}function a(f,d){return d===Uc?f.mapping=_r:d===Fc&&(f.mapping=So),f}function l(f){let d=0,m=6;for(let y=0;y<m;y++)f[y]!==void 0&&d++;return d===m}function c(f){let d=f.target;d.removeEventListener("dispose",c);let m=t.get(d);m!==void 0&&(t.delete(d),m.dispose())}function h(f){let d=f.target;d.removeEventListener("dispose",h);let m=e.get(d);m!==void 0&&(e.delete(d),m.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function gb(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&na("WebGLRenderer: "+n+" extension not supported."),s}}}function _b(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&t.remove(m.index);for(let p in m.attributes)t.remove(m.attributes[p]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let y=r.get(m);y&&(t.remove(y),r.delete(m)),n.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function c(m,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function h(m){let y=m.attributes;for(let p in y)t.update(y[p],i.ARRAY_BUFFER)}function u(m){let y=m.index,p=m.attributes.position,g=0;if(p===void 0)return;let v=y!==null?y.array.length:p.array.length/3-1,C=p.count>=65535?da:fa,S=new C(Math.ceil(v/3)*6,1),P=S.array;if(y!==null){let _=y.array;g=y.version;for(let b=0,O=0;b<v;b+=3){let D=_[b+0],A=_[b+1],F=_[b+2];P[O++]=D,P[O++]=A,P[O++]=A,P[O++]=F,P[O++]=F,P[O++]=D}}else{g=p.version;for(let _=0,b=0;_<v;_+=3){let O=_+0,D=_+1,A=_+2;P[b++]=O,P[b++]=D,P[b++]=D,P[b++]=A,P[b++]=A,P[b++]=O}}S.version=g;let E=r.get(m);E&&t.remove(E),r.set(m,S)}function f(m){let y=r.get(m);if(y){let p=m.index;p!==null&&y.version<p.version&&u(m)}else u(m);return r.get(m)}function d(){for(let m in s){let y=s[m].deref();y!==void 0&&l(y)}}return{get:c,update:h,getWireframeAttribute:f,dispose:d}}function xb(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,f){i.drawElements(n,f,r,u*o),e.update(f,n,1)}function c(u,f,d){d!==0&&(i.drawElementsInstanced(n,f,r,u*o,d),e.update(f,n,d))}function h(u,f,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,r,u,0,d);let y=0;for(let p=0;p<d;p++)y+=f[p];e.update(y,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function yb(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:ie("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function vb(i,t,e){let n=new WeakMap,s=new je;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,f=n.get(a);if(f===void 0||f.count!==u){let O=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",O)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],C=0;d===!0&&(C=1),m===!0&&(C=2),y===!0&&(C=3);let S=a.attributes.position.count*C,P=1;S>t.maxTextureSize&&(P=Math.ceil(S/t.maxTextureSize),S=t.maxTextureSize);let E=new Float32Array(S*P*4*u),_=new ca(E,S,P,u);_.type=Oi,_.needsUpdate=!0;let b=C*4;for(let D=0;D<u;D++){let A=p[D],F=g[D],G=v[D],N=S*P*4*D;for(let V=0;V<A.count;V++){let $=V*b;d===!0&&(s.fromBufferAttribute(A,V),E[N+$+0]=s.x,E[N+$+1]=s.y,E[N+$+2]=s.z,E[N+$+3]=0),m===!0&&(s.fromBufferAttribute(F,V),E[N+$+4]=s.x,E[N+$+5]=s.y,E[N+$+6]=s.z,E[N+$+7]=0),y===!0&&(s.fromBufferAttribute(G,V),E[N+$+8]=s.x,E[N+$+9]=s.y,E[N+$+10]=s.z,E[N+$+11]=G.itemSize===4?s.w:1)}}f={count:u,texture:_,size:new Zt(S,P)},n.set(a,f),a.addEventListener("dispose",O)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let d=0;for(let y=0;y<c.length;y++)d+=c[y];let m=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function Sb(i,t,e,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,f=t.get(c,u);if(r.get(f)!==h&&(t.update(f),r.set(f,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==h&&(d.update(),r.set(d,h))}return f}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var Mb={[nf]:"LINEAR_TONE_MAPPING",[sf]:"REINHARD_TONE_MAPPING",[rf]:"CINEON_TONE_MAPPING",[of]:"ACES_FILMIC_TONE_MAPPING",[lf]:"AGX_TONE_MAPPING",[cf]:"NEUTRAL_TONE_MAPPING",[af]:"CUSTOM_TONE_MAPPING"};function bb(i,t,e,n,s,r){let o=new pi(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new ln;h.setAttribute("position",new Re([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Re([0,2,0,0,2,0],2));let u=new vc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new Mn(h,u),d=new Aa(-1,1,1,-1,0,1),m=null,y=null,p=!1,g,v=null,C=[],S=!1;this.setSize=function(P,E){o.setSize(P,E),a!==null&&a.setSize(P,E),l!==null&&l.setSize(P,E);for(let _=0;_<C.length;_++){let b=C[_];b.setSize&&b.setSize(P,E)}},this.setEffects=function(P){C=P,S=C.length>0&&C[0].isRenderPass===!0;let E=o.width,_=o.height;C.length>0&&a===null&&(a=new pi(E,_,{type:Bi,depthBuffer:!1,stencilBuffer:!1}),l=new pi(E,_,{type:Bi,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&C.some(O=>O.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&c===null&&(c=new bs(E,_),r===!0&&(c.format=Ts,c.type=xr)),o.dispose(),o.depthTexture=b?c:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let O=0;O<C.length;O++){let D=C[O];D.setSize&&D.setSize(E,_),b&&D.needsDepthTexture===!0&&D.setDepthTexture&&D.setDepthTexture(c)}},this.begin=function(P,E){if(p||P.toneMapping===os&&C.length===0)return!1;if(v=E,E!==null){let _=E.width,b=E.height;(o.width!==_||o.height!==b)&&this.setSize(_,b)}return S===!1&&P.setRenderTarget(o),g=P.toneMapping,P.toneMapping=os,!0},this.hasRenderPass=function(){return S},this.end=function(P,E){P.toneMapping=g,p=!0;let _=o,b=a;for(let O=0;O<C.length;O++){let D=C[O];D.enabled!==!1&&(D.render(P,b,_,E),D.needsSwap!==!1&&(_=b,b=b===a?l:a))}if(m!==P.outputColorSpace||y!==P.toneMapping){m=P.outputColorSpace,y=P.toneMapping,u.defines={},Se.getTransfer(m)===Le&&(u.defines.SRGB_TRANSFER="");let O=Mb[y];O&&(u.defines[O]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=_.texture,P.setRenderTarget(v),P.render(f,d),v=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var Pg=new Qn,Ig=new bs(1,1),Lg=new xa(1),Dg=new ca,Ng=new pc,Ug=new ga,cg=[],hg=[],ug=new Float32Array(16),fg=new Float32Array(9),dg=new Float32Array(4);function wo(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=cg[s];if(r===void 0&&(r=new Float32Array(s),cg[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function bn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function wn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Eh(i,t){let e=hg[t];e===void 0&&(e=new Int32Array(t),hg[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function wb(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function Tb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(bn(e,t))return;i.uniform2fv(this.addr,t),wn(e,t)}}function Eb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(bn(e,t))return;i.uniform3fv(this.addr,t),wn(e,t)}}function Ab(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(bn(e,t))return;i.uniform4fv(this.addr,t),wn(e,t)}}function Cb(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(bn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),wn(e,t)}else{if(bn(e,n))return;dg.set(n),i.uniformMatrix2fv(this.addr,!1,dg),wn(e,n)}}function Rb(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(bn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),wn(e,t)}else{if(bn(e,n))return;fg.set(n),i.uniformMatrix3fv(this.addr,!1,fg),wn(e,n)}}function Pb(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(bn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),wn(e,t)}else{if(bn(e,n))return;ug.set(n),i.uniformMatrix4fv(this.addr,!1,ug),wn(e,n)}}function Ib(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function Lb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(bn(e,t))return;i.uniform2iv(this.addr,t),wn(e,t)}}function Db(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(bn(e,t))return;i.uniform3iv(this.addr,t),wn(e,t)}}function Nb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(bn(e,t))return;i.uniform4iv(this.addr,t),wn(e,t)}}function Ub(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function Fb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(bn(e,t))return;i.uniform2uiv(this.addr,t),wn(e,t)}}function Ob(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(bn(e,t))return;i.uniform3uiv(this.addr,t),wn(e,t)}}function Bb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(bn(e,t))return;i.uniform4uiv(this.addr,t),wn(e,t)}}function Ah(i){return i.version===0&&(i.compareFunction=vf,i.needsUpdate=!0),i}function kb(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Ah(Ig):r=Pg,e.setTexture2D(t||r,s)}function zb(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Ng,s)}function Vb(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Ah(Lg):r=Ug,e.setTextureCube(t||r,s)}function Gb(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Dg,s)}function Hb(i){switch(i){case 5126:return wb;case 35664:return Tb;case 35665:return Eb;case 35666:return Ab;case 35674:return Cb;case 35675:return Rb;case 35676:return Pb;case 5124:case 35670:return Ib;case 35667:case 35671:return Lb;case 35668:case 35672:return Db;case 35669:case 35673:return Nb;case 5125:return Ub;case 36294:return Fb;case 36295:return Ob;case 36296:return Bb;case 35678:case 36198:case 36298:case 36306:case 35682:return kb;case 35679:case 36299:case 36307:return zb;case 35680:case 36300:case 36308:case 36293:return Vb;case 36289:case 36303:case 36311:case 36292:return Gb}}function Wb(i,t){i.uniform1fv(this.addr,t)}function Xb(i,t){let e=wo(t,this.size,2);i.uniform2fv(this.addr,e)}function qb(i,t){let e=wo(t,this.size,3);i.uniform3fv(this.addr,e)}function $b(i,t){let e=wo(t,this.size,4);i.uniform4fv(this.addr,e)}function Yb(i,t){let e=wo(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function Zb(i,t){let e=wo(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function Jb(i,t){let e=wo(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function Kb(i,t){i.uniform1iv(this.addr,t)}function jb(i,t){i.uniform2iv(this.addr,t)}function Qb(i,t){i.uniform3iv(this.addr,t)}function tw(i,t){i.uniform4iv(this.addr,t)}function ew(i,t){i.uniform1uiv(this.addr,t)}function nw(i,t){i.uniform2uiv(this.addr,t)}function iw(i,t){i.uniform3uiv(this.addr,t)}function sw(i,t){i.uniform4uiv(this.addr,t)}function rw(i,t,e){let n=this.cache,s=t.length,r=Eh(e,s);bn(n,r)||(i.uniform1iv(this.addr,r),wn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Ah(Ig):o=Pg;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function ow(i,t,e){let n=this.cache,s=t.length,r=Eh(e,s);bn(n,r)||(i.uniform1iv(this.addr,r),wn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Ng,r[o])}function aw(i,t,e){let n=this.cache,s=t.length,r=Eh(e,s);bn(n,r)||(i.uniform1iv(this.addr,r),wn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Ah(Lg):o=Ug;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function lw(i,t,e){let n=this.cache,s=t.length,r=Eh(e,s);bn(n,r)||(i.uniform1iv(this.addr,r),wn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Dg,r[o])}function cw(i){switch(i){case 5126:return Wb;case 35664:return Xb;case 35665:return qb;case 35666:return $b;case 35674:return Yb;case 35675:return Zb;case 35676:return Jb;case 5124:case 35670:return Kb;case 35667:case 35671:return jb;case 35668:case 35672:return Qb;case 35669:case 35673:return tw;case 5125:return ew;case 36294:return nw;case 36295:return iw;case 36296:return sw;case 35678:case 36198:case 36298:case 36306:case 35682:return rw;case 35679:case 36299:case 36307:return ow;case 35680:case 36300:case 36308:case 36293:return aw;case 36289:case 36303:case 36311:case 36292:return lw}}var Nf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=Hb(e.type)}},Uf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=cw(e.type)}},Ff=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},Lf=/(\w+)(\])?(\[|\.)?/g;function pg(i,t){i.seq.push(t),i.map[t.id]=t}function hw(i,t,e){let n=i.name,s=n.length;for(Lf.lastIndex=0;;){let r=Lf.exec(n),o=Lf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){pg(e,c===void 0?new Nf(a,i,t):new Uf(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new Ff(a),pg(e,u)),e=u}}}var bo=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);hw(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function mg(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var uw=37297,fw=0;function dw(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var gg=new re;function pw(i){Se._getMatrix(gg,Se.workingColorSpace,i);let t=`mat3( ${gg.elements.map(e=>e.toFixed(4))} )`;switch(Se.getTransfer(i)){case oa:return[t,"LinearTransferOETF"];case Le:return[t,"sRGBTransferOETF"];default:return jt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function _g(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+dw(i.getShaderSource(t),a)}else return r}function mw(i,t){let e=pw(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var gw={[nf]:"Linear",[sf]:"Reinhard",[rf]:"Cineon",[of]:"ACESFilmic",[lf]:"AgX",[cf]:"Neutral",[af]:"Custom"};function _w(i,t){let e=gw[t];return e===void 0?(jt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var bh=new X;function xw(){Se.getLuminanceCoefficients(bh);let i=bh.x.toFixed(4),t=bh.y.toFixed(4),e=bh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function yw(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Va).join(`
`)}function vw(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function Sw(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Va(i){return i!==""}function xg(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function yg(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Mw=/^[ \t]*#include +<([\w\d./]+)>/gm;function Of(i){return i.replace(Mw,bw)}function bw(i,t){let e=pe[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Of(e)}var ww=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function vg(i){return i.replace(ww,Tw)}function Tw(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Sg(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var Ew={[La]:"SHADOWMAP_TYPE_PCF",[yo]:"SHADOWMAP_TYPE_VSM"};function Aw(i){return Ew[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Cw={[So]:"ENVMAP_MODE_REFRACTION"};function Rw(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":Cw[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Pw={[ef]:"ENVMAP_BLENDING_MULTIPLY",[km]:"ENVMAP_BLENDING_MIX",[zm]:"ENVMAP_BLENDING_ADD"};function Iw(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":Pw[i.combine]||"ENVMAP_BLENDING_NONE"}function Lw(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=Aw(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Rw(e),u=Iw(e),f=yw(e),d=vw(r),m=s.createProgram(),y,p,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Va).join(`
`),y.length>0&&(y+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Va).join(`
`),p.length>0&&(p+=`
`)):(y=[Sg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Va).join(`
`),p=[Sg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==os?"#define TONE_MAPPING":"",e.toneMapping!==os?pe.tonemapping_pars_fragment:"",e.toneMapping!==os?_w("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",pe.colorspace_pars_fragment,mw("linearToOutputTexel",e.outputColorSpace),xw(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Va).join(`
`)),o=Of(o),o=xg(o,e),o=yg(o,e),a=Of(a),a=xg(a,e),a=yg(a,e),o=vg(o),a=vg(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,y=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,p=["#define varying in",e.glslVersion===Mf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Mf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let v=g+y+o,C=g+p+a,S=mg(s,s.VERTEX_SHADER,v),P=mg(s,s.FRAGMENT_SHADER,C);s.attachShader(m,S),s.attachShader(m,P),e.index0AttributeName!==void 0?s.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function E(D){if(i.debug.checkShaderErrors){let A=s.getProgramInfoLog(m)||"",F=s.getShaderInfoLog(S)||"",G=s.getShaderInfoLog(P)||"",N=A.trim(),V=F.trim(),$=G.trim(),H=!0,ct=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(H=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,m,S,P);else{let K=_g(s,S,"vertex"),tt=_g(s,P,"fragment");ie("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+D.name+`
Material Type: `+D.type+`

Program Info Log: `+N+`
`+K+`
`+tt)}else N!==""?jt("WebGLProgram: Program Info Log:",N):(V===""||$==="")&&(ct=!1);ct&&(D.diagnostics={runnable:H,programLog:N,vertexShader:{log:V,prefix:y},fragmentShader:{log:$,prefix:p}})}s.deleteShader(S),s.deleteShader(P),_=new bo(s,m),b=Sw(s,m)}let _;this.getUniforms=function(){return _===void 0&&E(this),_};let b;this.getAttributes=function(){return b===void 0&&E(this),b};let O=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return O===!1&&(O=s.getProgramParameter(m,uw)),O},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=fw++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=S,this.fragmentShader=P,this}var Dw=0,Bf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new kf(t),e.set(t,n)),n}},kf=class{constructor(t){this.id=Dw++,this.code=t,this.usedTimes=0}};function Nw(i){return i===Zs||i===Ba||i===ka}function Uw(i,t,e,n,s,r){let o=new ha,a=new Bf,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(_){return l.add(_),_===0?"uv":`uv${_}`}function m(_,b,O,D,A,F){let G=D.fog,N=A.geometry,V=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?D.environment:null,$=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,H=t.get(_.envMap||V,$),ct=f[_.type],K=n.precision;_.precision!==null&&(K=n.getMaxPrecision(_.precision),K!==_.precision&&jt("WebGLProgram.getParameters:",_.precision,"not supported, using",K,"instead."));let tt=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,nt=tt!==void 0?tt.length:0,pt=0;N.morphAttributes.position!==void 0&&(pt=1),N.morphAttributes.normal!==void 0&&(pt=2),N.morphAttributes.color!==void 0&&(pt=3);let ft,et,_t,vt;if(ct){let It=ls[ct];ft=It.vertexShader,et=It.fragmentShader}else{ft=_.vertexShader,et=_.fragmentShader;let It=a.getVertexShaderStage(_),ue=a.getFragmentShaderStage(_);a.update(_,It,ue),_t=It.id,vt=ue.id}let Pt=i.getRenderTarget(),wt=i.state.buffers.depth.getReversed(),$t=A.isInstancedMesh===!0,le=A.isBatchedMesh===!0,Xt=!!_.map,me=!!_.matcap,fe=!!H,oe=fe&&H.isPMREMTexture===!0,Je=!!_.aoMap,He=!!_.lightMap,un=!!_.bumpMap&&_.wireframe===!1,Be=!!_.normalMap,Cn=!!_.displacementMap,be=!!_.emissiveMap,yn=!!_.metalnessMap,nn=!!_.roughnessMap,fn=_.anisotropy>0,k=_.clearcoat>0,Lt=_.diffuseRoughness>0,Qt=_.dispersion>0,ce=_.retroreflectivity>0,Tt=_.iridescence>0,ze=_.sheen>0,Ht=_.transmission>0,Kt=fn&&!!_.anisotropyMap,I=k&&!!_.clearcoatMap,M=k&&!!_.clearcoatNormalMap,q=k&&!!_.clearcoatRoughnessMap,ut=Lt&&!!_.diffuseRoughnessMap,at=Tt&&!!_.iridescenceMap,yt=Tt&&!!_.iridescenceThicknessMap,St=ze&&!!_.sheenColorMap,it=ze&&!!_.sheenRoughnessMap,rt=!!_.specularMap,gt=!!_.specularColorMap,B=!!_.specularIntensityMap,ot=Ht&&!!_.transmissionMap,st=Ht&&!!_.thicknessMap,Et=!!_.gradientMap,xt=!!_.alphaMap,bt=_.alphaTest>0,qt=!!_.alphaHash,ee=!!_.extensions,ht=os;_.toneMapped&&(Pt===null||Pt.isXRRenderTarget===!0)&&(ht=i.toneMapping);let zt=oe?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,ne={shaderID:ct,shaderType:_.type,shaderName:_.name,vertexShader:ft,fragmentShader:et,defines:_.defines,customVertexShaderID:_t,customFragmentShaderID:vt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:K,batching:le,batchingColor:le&&A._colorsTexture!==null,instancing:$t,instancingColor:$t&&A.instanceColor!==null,instancingMorph:$t&&A.morphTexture!==null,outputColorSpace:Pt===null?i.outputColorSpace:Pt.isXRRenderTarget===!0?Pt.texture.colorSpace:Se.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Xt,matcap:me,envMap:fe,envMapMode:fe&&H.mapping,envMapPMREM:oe,envMapMaxLod:oe?zt.length-1:null,envMapSize:oe?zt[0].width:null,aoMap:Je,lightMap:He,bumpMap:un,normalMap:Be,displacementMap:Cn,emissiveMap:be,normalMapObjectSpace:Be&&_.normalMapType===Hm,normalMapTangentSpace:Be&&_.normalMapType===vh,packedNormalMap:Be&&_.normalMapType===vh&&Nw(_.normalMap.format),metalnessMap:yn,roughnessMap:nn,anisotropy:fn,anisotropyMap:Kt,clearcoat:k,clearcoatMap:I,clearcoatNormalMap:M,clearcoatRoughnessMap:q,diffuseRoughness:Lt,diffuseRoughnessMap:ut,dispersion:Qt,retroreflection:ce,iridescence:Tt,iridescenceMap:at,iridescenceThicknessMap:yt,sheen:ze,sheenColorMap:St,sheenRoughnessMap:it,specularMap:rt,specularColorMap:gt,specularIntensityMap:B,transmission:Ht,transmissionMap:ot,thicknessMap:st,gradientMap:Et,opaque:_.transparent===!1&&_.blending===vo&&_.alphaToCoverage===!1,alphaMap:xt,alphaTest:bt,alphaHash:qt,combine:_.combine,mapUv:Xt&&d(_.map.channel),aoMapUv:Je&&d(_.aoMap.channel),lightMapUv:He&&d(_.lightMap.channel),bumpMapUv:un&&d(_.bumpMap.channel),normalMapUv:Be&&d(_.normalMap.channel),displacementMapUv:Cn&&d(_.displacementMap.channel),emissiveMapUv:be&&d(_.emissiveMap.channel),metalnessMapUv:yn&&d(_.metalnessMap.channel),roughnessMapUv:nn&&d(_.roughnessMap.channel),anisotropyMapUv:Kt&&d(_.anisotropyMap.channel),clearcoatMapUv:I&&d(_.clearcoatMap.channel),clearcoatNormalMapUv:M&&d(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&d(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ut&&d(_.diffuseRoughnessMap.channel),iridescenceMapUv:at&&d(_.iridescenceMap.channel),iridescenceThicknessMapUv:yt&&d(_.iridescenceThicknessMap.channel),sheenColorMapUv:St&&d(_.sheenColorMap.channel),sheenRoughnessMapUv:it&&d(_.sheenRoughnessMap.channel),specularMapUv:rt&&d(_.specularMap.channel),specularColorMapUv:gt&&d(_.specularColorMap.channel),specularIntensityMapUv:B&&d(_.specularIntensityMap.channel),transmissionMapUv:ot&&d(_.transmissionMap.channel),thicknessMapUv:st&&d(_.thicknessMap.channel),alphaMapUv:xt&&d(_.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Be||fn),vertexNormals:!!N.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:A.isPoints===!0&&!!N.attributes.uv&&(Xt||xt),fog:!!G,useFog:_.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||N.attributes.normal===void 0&&Be===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:wt,skinning:A.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:nt,morphTextureStride:pt,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:F.filter(It=>It.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&O.length>0,shadowMapType:i.shadowMap.type,toneMapping:ht,decodeVideoTexture:Xt&&_.map.isVideoTexture===!0&&Se.getTransfer(_.map.colorSpace)===Le,decodeVideoTextureEmissive:be&&_.emissiveMap.isVideoTexture===!0&&Se.getTransfer(_.emissiveMap.colorSpace)===Le,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===si,flipSided:_.side===ti,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:ee&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ee&&_.extensions.multiDraw===!0||le)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return ne.vertexUv1s=l.has(1),ne.vertexUv2s=l.has(2),ne.vertexUv3s=l.has(3),l.clear(),ne}function y(_){let b=[];if(_.shaderID?b.push(_.shaderID):(b.push(_.customVertexShaderID),b.push(_.customFragmentShaderID)),_.defines!==void 0)for(let O in _.defines)b.push(O),b.push(_.defines[O]);return _.isRawShaderMaterial===!1&&(p(b,_),g(b,_),b.push(i.outputColorSpace)),b.push(_.customProgramCacheKey),b.join()}function p(_,b){_.push(b.precision),_.push(b.outputColorSpace),_.push(b.envMapMode),_.push(b.envMapPMREM),_.push(b.envMapMaxLod),_.push(b.envMapSize),_.push(b.mapUv),_.push(b.alphaMapUv),_.push(b.lightMapUv),_.push(b.aoMapUv),_.push(b.bumpMapUv),_.push(b.normalMapUv),_.push(b.displacementMapUv),_.push(b.emissiveMapUv),_.push(b.metalnessMapUv),_.push(b.roughnessMapUv),_.push(b.anisotropyMapUv),_.push(b.clearcoatMapUv),_.push(b.clearcoatNormalMapUv),_.push(b.clearcoatRoughnessMapUv),_.push(b.diffuseRoughnessMapUv),_.push(b.iridescenceMapUv),_.push(b.iridescenceThicknessMapUv),_.push(b.sheenColorMapUv),_.push(b.sheenRoughnessMapUv),_.push(b.specularMapUv),_.push(b.specularColorMapUv),_.push(b.specularIntensityMapUv),_.push(b.transmissionMapUv),_.push(b.thicknessMapUv),_.push(b.combine),_.push(b.fogExp2),_.push(b.sizeAttenuation),_.push(b.morphTargetsCount),_.push(b.numSunLights),_.push(b.numDirLights),_.push(b.numPointLights),_.push(b.numSpotLights),_.push(b.numSpotLightMaps),_.push(b.numHemiLights),_.push(b.numRectAreaLights),_.push(b.numSunLightShadows),_.push(b.numDirLightShadows),_.push(b.numPointLightShadows),_.push(b.numSpotLightShadows),_.push(b.numSpotLightShadowsWithMaps),_.push(b.numLightProbes),_.push(b.numLightProbeGrids),_.push(b.shadowMapType),_.push(b.toneMapping),_.push(b.numClippingPlanes),_.push(b.numClipIntersection),_.push(b.depthPacking)}function g(_,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function v(_){let b=f[_.type],O;if(b){let D=ls[b];O=ng.clone(D.uniforms)}else O=_.uniforms;return O}function C(_,b){let O=h.get(b);return O!==void 0?++O.usedTimes:(O=new Lw(i,b,_,s),c.push(O),h.set(b,O)),O}function S(_){if(--_.usedTimes===0){let b=c.indexOf(_);c[b]=c[c.length-1],c.pop(),h.delete(_.cacheKey),_.destroy()}}function P(_){a.remove(_)}function E(){a.dispose()}return{getParameters:m,getProgramCacheKey:y,getUniforms:v,acquireProgram:C,releaseProgram:S,releaseShaderCache:P,programs:c,dispose:E}}function Fw(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function Ow(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function Mg(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function bg(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,m,y,p,g){let v=i[t];return v===void 0?(v={id:f.id,object:f,geometry:d,material:m,materialVariant:o(f),groupOrder:y,renderOrder:f.renderOrder,z:p,group:g},i[t]=v):(v.id=f.id,v.object=f,v.geometry=d,v.material=m,v.materialVariant=o(f),v.groupOrder=y,v.renderOrder=f.renderOrder,v.z=p,v.group=g),t++,v}function l(f,d,m,y,p,g,v){v.reversedDepth===!0&&(p=-p);let C=a(f,d,m,y,p,g);m.transmission>0?n.push(C):m.transparent===!0?s.push(C):e.push(C)}function c(f,d,m,y,p,g){let v=a(f,d,m,y,p,g);m.transmission>0?n.unshift(v):m.transparent===!0?s.unshift(v):e.unshift(v)}function h(f,d){e.length>1&&e.sort(f||Ow),n.length>1&&n.sort(d||Mg),s.length>1&&s.sort(d||Mg)}function u(){for(let f=t,d=i.length;f<d;f++){let m=i[f];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function Bw(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new bg,i.set(n,[o])):s>=r.length?(o=new bg,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function kw(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new X,color:new he};break;case"SpotLight":e={position:new X,direction:new X,color:new he,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new X,color:new he,distance:0,decay:0};break;case"HemisphereLight":e={direction:new X,skyColor:new he,groundColor:new he};break;case"RectAreaLight":e={color:new he,position:new X,halfWidth:new X,halfHeight:new X};break}return i[t.id]=e,e}}}function zw(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var Vw=0;function Gw(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function Hw(i){let t=new kw,e=zw(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new X);let s=new X,r=new De,o=new De;function a(c){let h=0,u=0,f=0;for(let F=0;F<9;F++)n.probe[F].set(0,0,0);let d=0,m=0,y=0,p=0,g=0,v=0,C=0,S=0,P=0,E=0,_=0,b=0,O=0,D=0;c.sort(Gw);for(let F=0,G=c.length;F<G;F++){let N=c[F],V=N.color,$=N.intensity,H=N.distance,ct=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===Zs?ct=N.shadow.map.texture:ct=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)h+=V.r*$,u+=V.g*$,f+=V.b*$;else if(N.isLightProbe){for(let K=0;K<9;K++)n.probe[K].addScaledVector(N.sh.coefficients[K],$);D++}else if(N.isSunLight){let K=t.get(N);if(K.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let tt=N.shadow,nt=e.get(N);nt.shadowIntensity=tt.intensity,nt.shadowBias=tt.bias,nt.shadowNormalBias=tt.normalBias,nt.shadowRadius=tt.radius,nt.shadowMapSize.copy(tt.mapSize).multiply(tt.getFrameExtents()),n.sunShadow[m]=nt,n.sunShadowMap[m]=ct;let pt=tt.getViewportCount();for(let ft=0;ft<pt;ft++)n.sunShadowMatrix[y+ft]=tt.getMatrix(ft),n.sunShadowCascade[y+ft]=tt._cascadeData[ft];y+=pt,m++}n.sun[d]=K,d++}else if(N.isDirectionalLight){let K=t.get(N);if(K.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let tt=N.shadow,nt=e.get(N);nt.shadowIntensity=tt.intensity,nt.shadowBias=tt.bias,nt.shadowNormalBias=tt.normalBias,nt.shadowRadius=tt.radius,nt.shadowMapSize=tt.mapSize,n.directionalShadow[p]=nt,n.directionalShadowMap[p]=ct,n.directionalShadowMatrix[p]=N.shadow.matrix,P++}n.directional[p]=K,p++}else if(N.isSpotLight){let K=t.get(N);K.position.setFromMatrixPosition(N.matrixWorld),K.color.copy(V).multiplyScalar($),K.distance=H,K.coneCos=Math.cos(N.angle),K.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),K.decay=N.decay,n.spot[v]=K;let tt=N.shadow;if(N.map&&(n.spotLightMap[b]=N.map,b++,tt.updateMatrices(N),N.castShadow&&O++),n.spotLightMatrix[v]=tt.matrix,N.castShadow){let nt=e.get(N);nt.shadowIntensity=tt.intensity,nt.shadowBias=tt.bias,nt.shadowNormalBias=tt.normalBias,nt.shadowRadius=tt.radius,nt.shadowMapSize=tt.mapSize,n.spotShadow[v]=nt,n.spotShadowMap[v]=ct,_++}v++}else if(N.isRectAreaLight){let K=t.get(N);K.color.copy(V).multiplyScalar($),K.halfWidth.set(N.width*.5,0,0),K.halfHeight.set(0,N.height*.5,0),n.rectArea[C]=K,C++}else if(N.isPointLight){let K=t.get(N);if(K.color.copy(N.color).multiplyScalar(N.intensity),K.distance=N.distance,K.decay=N.decay,N.castShadow){let tt=N.shadow,nt=e.get(N);nt.shadowIntensity=tt.intensity,nt.shadowBias=tt.bias,nt.shadowNormalBias=tt.normalBias,nt.shadowRadius=tt.radius,nt.shadowMapSize=tt.mapSize,nt.shadowCameraNear=tt.camera.near,nt.shadowCameraFar=tt.camera.far,n.pointShadow[g]=nt,n.pointShadowMap[g]=ct,n.pointShadowMatrix[g]=N.shadow.matrix,E++}n.point[g]=K,g++}else if(N.isHemisphereLight){let K=t.get(N);K.skyColor.copy(N.color).multiplyScalar($),K.groundColor.copy(N.groundColor).multiplyScalar($),n.hemi[S]=K,S++}}C>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ut.LTC_FLOAT_1,n.rectAreaLTC2=Ut.LTC_FLOAT_2):(n.rectAreaLTC1=Ut.LTC_HALF_1,n.rectAreaLTC2=Ut.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=f;let A=n.hash;(A.sunLength!==d||A.directionalLength!==p||A.pointLength!==g||A.spotLength!==v||A.rectAreaLength!==C||A.hemiLength!==S||A.numSunShadows!==m||A.numDirectionalShadows!==P||A.numPointShadows!==E||A.numSpotShadows!==_||A.numSpotMaps!==b||A.numLightProbes!==D)&&(n.sun.length=d,n.directional.length=p,n.spot.length=v,n.rectArea.length=C,n.point.length=g,n.hemi.length=S,n.sunShadow.length=m,n.sunShadowMap.length=m,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=P,n.directionalShadowMap.length=P,n.directionalShadowMatrix.length=P,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+b-O,n.spotLightMap.length=b,n.numSpotLightShadowsWithMaps=O,n.numLightProbes=D,A.sunLength=d,A.directionalLength=p,A.pointLength=g,A.spotLength=v,A.rectAreaLength=C,A.hemiLength=S,A.numSunShadows=m,A.numDirectionalShadows=P,A.numPointShadows=E,A.numSpotShadows=_,A.numSpotMaps=b,A.numLightProbes=D,n.version=Vw++)}function l(c,h){let u=0,f=0,d=0,m=0,y=0,p=0,g=h.matrixWorldInverse;for(let v=0,C=c.length;v<C;v++){let S=c[v];if(S.isSunLight){let P=n.sun[u];P.direction.setFromMatrixPosition(S.matrixWorld),P.direction.transformDirection(g),u++}else if(S.isDirectionalLight){let P=n.directional[f];P.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(g),f++}else if(S.isSpotLight){let P=n.spot[m];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(g),P.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(g),m++}else if(S.isRectAreaLight){let P=n.rectArea[y];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(g),o.identity(),r.copy(S.matrixWorld),r.premultiply(g),o.extractRotation(r),P.halfWidth.set(S.width*.5,0,0),P.halfHeight.set(0,S.height*.5,0),P.halfWidth.applyMatrix4(o),P.halfHeight.applyMatrix4(o),y++}else if(S.isPointLight){let P=n.point[d];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(g),d++}else if(S.isHemisphereLight){let P=n.hemi[p];P.direction.setFromMatrixPosition(S.matrixWorld),P.direction.transformDirection(g),p++}}}return{setup:a,setupView:l,state:n}}function wg(i){let t=new Hw(i),e=[],n=[],s=[];function r(u){h.camera=u,e.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){n.push(u)}function l(){t.setup(e),s.sort((u,f)=>u.priority-f.priority||u.id-f.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function Ww(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new wg(i),t.set(s,[a])):r>=o.length?(a=new wg(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var Xw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,qw=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,$w=[new X(1,0,0),new X(-1,0,0),new X(0,1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1)],Yw=[new X(0,-1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1),new X(0,-1,0),new X(0,-1,0)],Tg=new De,za=new X,Df=new X;function Zw(i,t,e){let n=new Gs,s=new Zt,r=new Zt,o=new je,a=new Sc,l=new Mc,c={},h=e.maxTextureSize,u={[Ys]:ti,[ti]:Ys,[si]:si},f=new ss({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Zt},radius:{value:4}},vertexShader:Xw,fragmentShader:qw}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let m=new ln;m.setAttribute("position",new Ni(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Mn(m,f),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=La;let g=this.type;this.render=function(E,_,b){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||E.length===0)return;this.type===vm&&(jt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=La);let O=i.getRenderTarget(),D=i.getActiveCubeFace(),A=i.getActiveMipmapLevel(),F=i.state;F.setBlending(mr),F.buffers.depth.getReversed()===!0?F.buffers.color.setClear(0,0,0,0):F.buffers.color.setClear(1,1,1,1),F.buffers.depth.setTest(!0),F.setScissorTest(!1);let G=g!==this.type;G&&_.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(V=>V.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,V=E.length;N<V;N++){let $=E[N],H=$.shadow;if(H===void 0){jt("WebGLShadowMap:",$,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let ct=H.getFrameExtents();s.multiply(ct),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ct.x),s.x=r.x*ct.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ct.y),s.y=r.y*ct.y,H.mapSize.y=r.y));let K=i.state.buffers.depth.getReversed();if(H.camera._reversedDepth=K,H.map===null||G===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===yo){if($.isPointLight){jt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new pi(s.x,s.y,{format:Zs,type:Bi,minFilter:Kn,magFilter:Kn,generateMipmaps:!1}),H.map.texture.name=$.name+".shadowMap",H.map.depthTexture=new bs(s.x,s.y,Oi),H.map.depthTexture.name=$.name+".shadowMapDepth",H.map.depthTexture.format=Ss,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Nn,H.map.depthTexture.magFilter=Nn}else $.isPointLight?(H.map=new Ga(s.x),H.map.depthTexture=new xa(s.x,Fi)):(H.map=new pi(s.x,s.y),H.map.depthTexture=new bs(s.x,s.y,Fi)),H.map.depthTexture.name=$.name+".shadowMap",H.map.depthTexture.format=Ss,this.type===La?(H.map.depthTexture.compareFunction=K?yf:xf,H.map.depthTexture.minFilter=Kn,H.map.depthTexture.magFilter=Kn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Nn,H.map.depthTexture.magFilter=Nn);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let tt=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();$.isPointLight!==!0&&H.updateMatrices($,b);let nt=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:b.layers;for(let pt=0;pt<tt;pt++){let ft=H.getCamera(pt);if($.isPointLight){let et=H.camera,_t=H.matrix,vt=$.distance||et.far;vt!==et.far&&(et.far=vt,et.updateProjectionMatrix()),za.setFromMatrixPosition($.matrixWorld),et.position.copy(za),Df.copy(et.position),Df.add($w[pt]),et.up.copy(Yw[pt]),et.lookAt(Df),et.updateMatrixWorld(),_t.makeTranslation(-za.x,-za.y,-za.z),Tg.multiplyMatrices(et.projectionMatrix,et.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Tg,et.coordinateSystem,et.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)i.setRenderTarget(H.map,pt),i.clear();else{pt===0&&(i.setRenderTarget(H.map),i.clear());let et=H.getViewport(pt);o.set(r.x*et.x,r.y*et.y,r.x*et.z,r.y*et.w),F.viewport(o)}n=H.getFrustum(pt),S(_,b,ft,$,nt,this.type)}H.isPointLightShadow!==!0&&this.type===yo&&v(H,b),H.needsUpdate=!1}g=this.type,p.needsUpdate=!1,i.setRenderTarget(O,D,A)};function v(E,_){let b=t.update(y);f.defines.VSM_SAMPLES!==E.blurSamples&&(f.defines.VSM_SAMPLES=E.blurSamples,d.defines.VSM_SAMPLES=E.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),E.mapPass===null?E.mapPass=new pi(s.x,s.y,{format:Zs,type:Bi}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),f.uniforms.shadow_pass.value=E.map.depthTexture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(_,null,b,f,y,null),d.uniforms.shadow_pass.value=E.mapPass.texture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(_,null,b,d,y,null)}function C(E,_,b,O){let D=null,A=b.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(A!==void 0)D=A;else if(D=b.isPointLight===!0?l:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let F=D.uuid,G=_.uuid,N=c[F];N===void 0&&(N={},c[F]=N);let V=N[G];V===void 0&&(V=D.clone(),N[G]=V,_.addEventListener("dispose",P)),D=V}if(D.visible=_.visible,D.wireframe=_.wireframe,O===yo?D.side=_.shadowSide!==null?_.shadowSide:_.side:D.side=_.shadowSide!==null?_.shadowSide:u[_.side],D.alphaMap=_.alphaMap,D.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,D.map=_.map,D.clipShadows=_.clipShadows,D.clippingPlanes=_.clippingPlanes,D.clipIntersection=_.clipIntersection,D.displacementMap=_.displacementMap,D.displacementScale=_.displacementScale,D.displacementBias=_.displacementBias,D.wireframeLinewidth=_.wireframeLinewidth,D.linewidth=_.linewidth,b.isPointLight===!0&&D.isMeshDistanceMaterial===!0){let F=i.properties.get(D);F.light=b}return D}function S(E,_,b,O,D,A){if(E.visible===!1)return;if(E.layers.test(D)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&A===yo)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,E.matrixWorld);let N=t.update(E),V=E.material;if(Array.isArray(V)){let $=N.groups;for(let H=0,ct=$.length;H<ct;H++){let K=$[H],tt=V[K.materialIndex];if(tt&&tt.visible){let nt=C(E,tt,O,A);E.onBeforeShadow(i,E,_,b,N,nt,K),i.renderBufferDirect(b,null,N,nt,E,K),E.onAfterShadow(i,E,_,b,N,nt,K)}}}else if(V.visible){let $=C(E,V,O,A);E.onBeforeShadow(i,E,_,b,N,$,null),i.renderBufferDirect(b,null,N,$,E,null),E.onAfterShadow(i,E,_,b,N,$,null)}}let G=E.children;for(let N=0,V=G.length;N<V;N++)S(G[N],_,b,O,D,A)}function P(E){E.target.removeEventListener("dispose",P);for(let b in c){let O=c[b],D=E.target.uuid;D in O&&(O[D].dispose(),delete O[D])}}}function Jw(i,t){function e(){let B=!1,ot=new je,st=null,Et=new je(0,0,0,0);return{setMask:function(xt){st!==xt&&!B&&(i.colorMask(xt,xt,xt,xt),st=xt)},setLocked:function(xt){B=xt},setClear:function(xt,bt,qt,ee,ht){ht===!0&&(xt*=ee,bt*=ee,qt*=ee),ot.set(xt,bt,qt,ee),Et.equals(ot)===!1&&(i.clearColor(xt,bt,qt,ee),Et.copy(ot))},reset:function(){B=!1,st=null,Et.set(-1,0,0,0)}}}function n(){let B=!1,ot=!1,st=null,Et=null,xt=null;return{setReversed:function(bt){if(ot!==bt){let qt=t.get("EXT_clip_control");bt?qt.clipControlEXT(qt.LOWER_LEFT_EXT,qt.ZERO_TO_ONE_EXT):qt.clipControlEXT(qt.LOWER_LEFT_EXT,qt.NEGATIVE_ONE_TO_ONE_EXT),ot=bt;let ee=xt;xt=null,this.setClear(ee)}},getReversed:function(){return ot},setTest:function(bt){bt?wt(i.DEPTH_TEST):$t(i.DEPTH_TEST)},setMask:function(bt){st!==bt&&!B&&(i.depthMask(bt),st=bt)},setFunc:function(bt){if(ot&&(bt=Qm[bt]),Et!==bt){switch(bt){case nc:i.depthFunc(i.NEVER);break;case ic:i.depthFunc(i.ALWAYS);break;case sc:i.depthFunc(i.LESS);break;case ao:i.depthFunc(i.LEQUAL);break;case rc:i.depthFunc(i.EQUAL);break;case oc:i.depthFunc(i.GEQUAL);break;case ac:i.depthFunc(i.GREATER);break;case lc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Et=bt}},setLocked:function(bt){B=bt},setClear:function(bt){xt!==bt&&(xt=bt,ot&&(bt=1-bt),i.clearDepth(bt))},reset:function(){B=!1,st=null,Et=null,xt=null,ot=!1}}}function s(){let B=!1,ot=null,st=null,Et=null,xt=null,bt=null,qt=null,ee=null,ht=null;return{setTest:function(zt){B||(zt?wt(i.STENCIL_TEST):$t(i.STENCIL_TEST))},setMask:function(zt){ot!==zt&&!B&&(i.stencilMask(zt),ot=zt)},setFunc:function(zt,ne,It){(st!==zt||Et!==ne||xt!==It)&&(i.stencilFunc(zt,ne,It),st=zt,Et=ne,xt=It)},setOp:function(zt,ne,It){(bt!==zt||qt!==ne||ee!==It)&&(i.stencilOp(zt,ne,It),bt=zt,qt=ne,ee=It)},setLocked:function(zt){B=zt},setClear:function(zt){ht!==zt&&(i.clearStencil(zt),ht=zt)},reset:function(){B=!1,ot=null,st=null,Et=null,xt=null,bt=null,qt=null,ee=null,ht=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,h={},u={},f={},d=new WeakMap,m=[],y=null,p=!1,g=null,v=null,C=null,S=null,P=null,E=null,_=null,b=new he(0,0,0),O=0,D=!1,A=null,F=null,G=null,N=null,V=null,$=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,ct=0,K=i.getParameter(i.VERSION);K.indexOf("WebGL")!==-1?(ct=parseFloat(/^WebGL (\d)/.exec(K)[1]),H=ct>=1):K.indexOf("OpenGL ES")!==-1&&(ct=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),H=ct>=2);let tt=null,nt={},pt=i.getParameter(i.SCISSOR_BOX),ft=i.getParameter(i.VIEWPORT),et=new je().fromArray(pt),_t=new je().fromArray(ft);function vt(B,ot,st,Et){let xt=new Uint8Array(4),bt=i.createTexture();i.bindTexture(B,bt),i.texParameteri(B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let qt=0;qt<st;qt++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(ot,0,i.RGBA,1,1,Et,0,i.RGBA,i.UNSIGNED_BYTE,xt):i.texImage2D(ot+qt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,xt);return bt}let Pt={};Pt[i.TEXTURE_2D]=vt(i.TEXTURE_2D,i.TEXTURE_2D,1),Pt[i.TEXTURE_CUBE_MAP]=vt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Pt[i.TEXTURE_2D_ARRAY]=vt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Pt[i.TEXTURE_3D]=vt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),wt(i.DEPTH_TEST),o.setFunc(ao),un(!1),Be(Zu),wt(i.CULL_FACE),Je(mr);function wt(B){h[B]!==!0&&(i.enable(B),h[B]=!0)}function $t(B){h[B]!==!1&&(i.disable(B),h[B]=!1)}function le(B,ot){return f[B]!==ot?(i.bindFramebuffer(B,ot),f[B]=ot,B===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=ot),B===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=ot),!0):!1}function Xt(B,ot){let st=m,Et=!1;if(B){st=d.get(ot),st===void 0&&(st=[],d.set(ot,st));let xt=B.textures;if(st.length!==xt.length||st[0]!==i.COLOR_ATTACHMENT0){for(let bt=0,qt=xt.length;bt<qt;bt++)st[bt]=i.COLOR_ATTACHMENT0+bt;st.length=xt.length,Et=!0}}else st[0]!==i.BACK&&(st[0]=i.BACK,Et=!0);Et&&i.drawBuffers(st)}function me(B){return y!==B?(i.useProgram(B),y=B,!0):!1}let fe={[gr]:i.FUNC_ADD,[Mm]:i.FUNC_SUBTRACT,[bm]:i.FUNC_REVERSE_SUBTRACT};fe[wm]=i.MIN,fe[Tm]=i.MAX;let oe={[Em]:i.ZERO,[Am]:i.ONE,[Cm]:i.SRC_COLOR,[Qu]:i.SRC_ALPHA,[Nm]:i.SRC_ALPHA_SATURATE,[Lm]:i.DST_COLOR,[Pm]:i.DST_ALPHA,[Rm]:i.ONE_MINUS_SRC_COLOR,[tf]:i.ONE_MINUS_SRC_ALPHA,[Dm]:i.ONE_MINUS_DST_COLOR,[Im]:i.ONE_MINUS_DST_ALPHA,[Um]:i.CONSTANT_COLOR,[Fm]:i.ONE_MINUS_CONSTANT_COLOR,[Om]:i.CONSTANT_ALPHA,[Bm]:i.ONE_MINUS_CONSTANT_ALPHA};function Je(B,ot,st,Et,xt,bt,qt,ee,ht,zt){if(B===mr){p===!0&&($t(i.BLEND),p=!1);return}if(p===!1&&(wt(i.BLEND),p=!0),B!==Sm){if(B!==g||zt!==D){if((v!==gr||P!==gr)&&(i.blendEquation(i.FUNC_ADD),v=gr,P=gr),zt)switch(B){case vo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Ju:i.blendFunc(i.ONE,i.ONE);break;case Ku:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case ju:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ie("WebGLState: Invalid blending: ",B);break}else switch(B){case vo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Ju:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Ku:ie("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ju:ie("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ie("WebGLState: Invalid blending: ",B);break}C=null,S=null,E=null,_=null,b.set(0,0,0),O=0,g=B,D=zt}return}xt=xt||ot,bt=bt||st,qt=qt||Et,(ot!==v||xt!==P)&&(i.blendEquationSeparate(fe[ot],fe[xt]),v=ot,P=xt),(st!==C||Et!==S||bt!==E||qt!==_)&&(i.blendFuncSeparate(oe[st],oe[Et],oe[bt],oe[qt]),C=st,S=Et,E=bt,_=qt),(ee.equals(b)===!1||ht!==O)&&(i.blendColor(ee.r,ee.g,ee.b,ht),b.copy(ee),O=ht),g=B,D=!1}function He(B,ot){B.side===si?$t(i.CULL_FACE):wt(i.CULL_FACE);let st=B.side===ti;ot&&(st=!st),un(st),B.blending===vo&&B.transparent===!1?Je(mr):Je(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let Et=B.stencilWrite;a.setTest(Et),Et&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),be(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?wt(i.SAMPLE_ALPHA_TO_COVERAGE):$t(i.SAMPLE_ALPHA_TO_COVERAGE)}function un(B){A!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),A=B)}function Be(B){B!==xm?(wt(i.CULL_FACE),B!==F&&(B===Zu?i.cullFace(i.BACK):B===ym?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):$t(i.CULL_FACE),F=B}function Cn(B){B!==G&&(H&&i.lineWidth(B),G=B)}function be(B,ot,st){B?(wt(i.POLYGON_OFFSET_FILL),(N!==ot||V!==st)&&(N=ot,V=st,o.getReversed()&&(ot=-ot,st=-st),i.polygonOffset(ot,st))):$t(i.POLYGON_OFFSET_FILL)}function yn(B){B?wt(i.SCISSOR_TEST):$t(i.SCISSOR_TEST)}function nn(B){B===void 0&&(B=i.TEXTURE0+$-1),tt!==B&&(i.activeTexture(B),tt=B)}function fn(B,ot,st){st===void 0&&(tt===null?st=i.TEXTURE0+$-1:st=tt);let Et=nt[st];Et===void 0&&(Et={type:void 0,texture:void 0},nt[st]=Et),(Et.type!==B||Et.texture!==ot)&&(tt!==st&&(i.activeTexture(st),tt=st),i.bindTexture(B,ot||Pt[B]),Et.type=B,Et.texture=ot)}function k(){let B=nt[tt];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Lt(){try{i.compressedTexImage2D(...arguments)}catch(B){ie("WebGLState:",B)}}function Qt(){try{i.compressedTexImage3D(...arguments)}catch(B){ie("WebGLState:",B)}}function ce(){try{i.texSubImage2D(...arguments)}catch(B){ie("WebGLState:",B)}}function Tt(){try{i.texSubImage3D(...arguments)}catch(B){ie("WebGLState:",B)}}function ze(){try{i.compressedTexSubImage2D(...arguments)}catch(B){ie("WebGLState:",B)}}function Ht(){try{i.compressedTexSubImage3D(...arguments)}catch(B){ie("WebGLState:",B)}}function Kt(){try{i.texStorage2D(...arguments)}catch(B){ie("WebGLState:",B)}}function I(){try{i.texStorage3D(...arguments)}catch(B){ie("WebGLState:",B)}}function M(){try{i.texImage2D(...arguments)}catch(B){ie("WebGLState:",B)}}function q(){try{i.texImage3D(...arguments)}catch(B){ie("WebGLState:",B)}}function ut(B){return u[B]!==void 0?u[B]:i.getParameter(B)}function at(B,ot){u[B]!==ot&&(i.pixelStorei(B,ot),u[B]=ot)}function yt(B){et.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),et.copy(B))}function St(B){_t.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),_t.copy(B))}function it(B,ot){let st=c.get(ot);st===void 0&&(st=new WeakMap,c.set(ot,st));let Et=st.get(B);Et===void 0&&(Et=i.getUniformBlockIndex(ot,B.name),i.uniformBlockBinding(ot,Et,Et),st.set(B,Et))}function rt(B,ot,st){let xt=c.get(ot).get(B);l[xt]!==st&&(i.bindBufferBase(i.UNIFORM_BUFFER,xt,st),l[xt]=st)}function gt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},tt=null,nt={},f={},l={},d=new WeakMap,m=[],y=null,p=!1,g=null,v=null,C=null,S=null,P=null,E=null,_=null,b=new he(0,0,0),O=0,D=!1,A=null,F=null,G=null,N=null,V=null,et.set(0,0,i.canvas.width,i.canvas.height),_t.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:wt,disable:$t,bindFramebuffer:le,drawBuffers:Xt,useProgram:me,setBlending:Je,setMaterial:He,setFlipSided:un,setCullFace:Be,setLineWidth:Cn,setPolygonOffset:be,setScissorTest:yn,activeTexture:nn,bindTexture:fn,unbindTexture:k,compressedTexImage2D:Lt,compressedTexImage3D:Qt,texImage2D:M,texImage3D:q,pixelStorei:at,getParameter:ut,updateUBOMapping:it,uniformBlockBinding:rt,texStorage2D:Kt,texStorage3D:I,texSubImage2D:ce,texSubImage3D:Tt,compressedTexSubImage2D:ze,compressedTexSubImage3D:Ht,scissor:yt,viewport:St,reset:gt}}function Kw(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Zt,h=new WeakMap,u=new Set,f,d=new WeakMap,m=new Set,y=new FinalizationRegistry(I=>m.delete(I)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(I,M){return p?new OffscreenCanvas(I,M):aa("canvas")}function v(I,M,q){let ut=1,at=Kt(I);if((at.width>q||at.height>q)&&(ut=q/Math.max(at.width,at.height)),ut<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let yt=Math.floor(ut*at.width),St=Math.floor(ut*at.height);f===void 0&&(f=g(yt,St));let it=M?g(yt,St):f;return it.width=yt,it.height=St,it.getContext("2d").drawImage(I,0,0,yt,St),jt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+yt+"x"+St+")."),it}else return"data"in I&&jt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),I;return I}function C(I){return I.generateMipmaps}function S(I){i.generateMipmap(I)}function P(I){return I.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?i.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(I,M,q,ut,at,yt=!1){if(I!==null){if(i[I]!==void 0)return i[I];jt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let St;ut&&(St=t.get("EXT_texture_norm16"),St||jt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let it=M;if(M===i.RED&&(q===i.FLOAT&&(it=i.R32F),q===i.HALF_FLOAT&&(it=i.R16F),q===i.UNSIGNED_BYTE&&(it=i.R8),q===i.UNSIGNED_SHORT&&St&&(it=St.R16_EXT),q===i.SHORT&&St&&(it=St.R16_SNORM_EXT)),M===i.RED_INTEGER&&(q===i.UNSIGNED_BYTE&&(it=i.R8UI),q===i.UNSIGNED_SHORT&&(it=i.R16UI),q===i.UNSIGNED_INT&&(it=i.R32UI),q===i.BYTE&&(it=i.R8I),q===i.SHORT&&(it=i.R16I),q===i.INT&&(it=i.R32I)),M===i.RG&&(q===i.FLOAT&&(it=i.RG32F),q===i.HALF_FLOAT&&(it=i.RG16F),q===i.UNSIGNED_BYTE&&(it=i.RG8),q===i.UNSIGNED_SHORT&&St&&(it=St.RG16_EXT),q===i.SHORT&&St&&(it=St.RG16_SNORM_EXT)),M===i.RG_INTEGER&&(q===i.UNSIGNED_BYTE&&(it=i.RG8UI),q===i.UNSIGNED_SHORT&&(it=i.RG16UI),q===i.UNSIGNED_INT&&(it=i.RG32UI),q===i.BYTE&&(it=i.RG8I),q===i.SHORT&&(it=i.RG16I),q===i.INT&&(it=i.RG32I)),M===i.RGB_INTEGER&&(q===i.UNSIGNED_BYTE&&(it=i.RGB8UI),q===i.UNSIGNED_SHORT&&(it=i.RGB16UI),q===i.UNSIGNED_INT&&(it=i.RGB32UI),q===i.BYTE&&(it=i.RGB8I),q===i.SHORT&&(it=i.RGB16I),q===i.INT&&(it=i.RGB32I)),M===i.RGBA_INTEGER&&(q===i.UNSIGNED_BYTE&&(it=i.RGBA8UI),q===i.UNSIGNED_SHORT&&(it=i.RGBA16UI),q===i.UNSIGNED_INT&&(it=i.RGBA32UI),q===i.BYTE&&(it=i.RGBA8I),q===i.SHORT&&(it=i.RGBA16I),q===i.INT&&(it=i.RGBA32I)),M===i.RGB&&(q===i.UNSIGNED_SHORT&&St&&(it=St.RGB16_EXT),q===i.SHORT&&St&&(it=St.RGB16_SNORM_EXT),q===i.UNSIGNED_INT_5_9_9_9_REV&&(it=i.RGB9_E5),q===i.UNSIGNED_INT_10F_11F_11F_REV&&(it=i.R11F_G11F_B10F)),M===i.RGBA){let rt=yt?oa:Se.getTransfer(at);q===i.FLOAT&&(it=i.RGBA32F),q===i.HALF_FLOAT&&(it=i.RGBA16F),q===i.UNSIGNED_BYTE&&(it=rt===Le?i.SRGB8_ALPHA8:i.RGBA8),q===i.UNSIGNED_SHORT&&St&&(it=St.RGBA16_EXT),q===i.SHORT&&St&&(it=St.RGBA16_SNORM_EXT),q===i.UNSIGNED_SHORT_4_4_4_4&&(it=i.RGBA4),q===i.UNSIGNED_SHORT_5_5_5_1&&(it=i.RGB5_A1)}return(it===i.R16F||it===i.R32F||it===i.RG16F||it===i.RG32F||it===i.RGBA16F||it===i.RGBA32F)&&t.get("EXT_color_buffer_float"),it}function _(I,M){let q;return I?M===null||M===Fi||M===xr?q=i.DEPTH24_STENCIL8:M===Oi?q=i.DEPTH32F_STENCIL8:M===Mo&&(q=i.DEPTH24_STENCIL8,jt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Fi||M===xr?q=i.DEPTH_COMPONENT24:M===Oi?q=i.DEPTH_COMPONENT32F:M===Mo&&(q=i.DEPTH_COMPONENT16),q}function b(I,M){return C(I)===!0||I.isFramebufferTexture&&I.minFilter!==Nn&&I.minFilter!==Kn?Math.log2(Math.max(M.width,M.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?M.mipmaps.length:1}function O(I){let M=new WeakRef(I);n.get(I).__ref=M,m.add(M),y.register(I,M,M)}function D(I){let M=n.get(I).__ref;M!==void 0&&(m.delete(M),y.unregister(M))}function A(I){G(I.target)}function F(I){N(I.target)}function G(I){I.removeEventListener("dispose",A),D(I),$(I),I.isVideoTexture&&h.delete(I),I.isHTMLTexture&&u.delete(I)}function N(I){I.removeEventListener("dispose",F),D(I),ct(I)}function V(){for(let I of m){let M=I.deref();M!==void 0&&(M.isRenderTarget===!0?N(M):G(M))}m.clear(),u.clear()}function $(I){let M=n.get(I);if(M.__webglInit===void 0)return;let q=I.source,ut=d.get(q);if(ut){let at=ut[M.__cacheKey];at.usedTimes--,at.usedTimes===0&&H(I),Object.keys(ut).length===0&&d.delete(q)}n.remove(I)}function H(I){let M=n.get(I);i.deleteTexture(M.__webglTexture);let q=I.source,ut=d.get(q);delete ut[M.__cacheKey],o.memory.textures--}function ct(I){let M=n.get(I);M.__depthDisposeCallback&&M.__depthDisposeCallback();let q=I.depthTexture;if(q&&q.renderTarget===I&&G(q),I.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(M.__webglFramebuffer[at]))for(let yt=0;yt<M.__webglFramebuffer[at].length;yt++)i.deleteFramebuffer(M.__webglFramebuffer[at][yt]);else i.deleteFramebuffer(M.__webglFramebuffer[at]);M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer[at])}else{if(Array.isArray(M.__webglFramebuffer))for(let at=0;at<M.__webglFramebuffer.length;at++)i.deleteFramebuffer(M.__webglFramebuffer[at]);else i.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&i.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let at=0;at<M.__webglColorRenderbuffer.length;at++)M.__webglColorRenderbuffer[at]&&i.deleteRenderbuffer(M.__webglColorRenderbuffer[at]);M.__webglDepthRenderbuffer&&i.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ut=I.textures;for(let at=0,yt=ut.length;at<yt;at++){let St=n.get(ut[at]);St.__webglTexture&&(i.deleteTexture(St.__webglTexture),o.memory.textures--),n.remove(ut[at])}n.remove(I)}let K=0;function tt(){K=0}function nt(){return K}function pt(I){K=I}function ft(){let I=K;return I>=s.maxTextures&&jt("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+s.maxTextures),K+=1,I}function et(I){let M=[];return M.push(I.wrapS),M.push(I.wrapT),M.push(I.wrapR||0),M.push(I.magFilter),M.push(I.minFilter),M.push(I.anisotropy),M.push(I.internalFormat),M.push(I.format),M.push(I.type),M.push(I.generateMipmaps),M.push(I.mipmapsAutoUpdate),M.push(I.premultiplyAlpha),M.push(I.flipY),M.push(I.unpackAlignment),M.push(I.colorSpace),M.join()}function _t(I,M){let q=n.get(I);if(I.isVideoTexture&&ze(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&q.__version!==I.version){let ut=I.image;if(ut===null)jt("WebGLRenderer: Texture marked for update but no image data found.");else if(ut.complete===!1)jt("WebGLRenderer: Texture marked for update but image is incomplete");else{He(q,I,M);return}}else I.isExternalTexture&&(q.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,q.__webglTexture,i.TEXTURE0+M)}function vt(I,M){let q=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&q.__version!==I.version){He(q,I,M);return}else I.isExternalTexture&&(q.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,q.__webglTexture,i.TEXTURE0+M)}function Pt(I,M){let q=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&q.__version!==I.version){He(q,I,M);return}e.bindTexture(i.TEXTURE_3D,q.__webglTexture,i.TEXTURE0+M)}function wt(I,M){let q=n.get(I);if(I.version>0&&q.__version!==I.version){un(q,I,M);return}e.bindTexture(i.TEXTURE_CUBE_MAP,q.__webglTexture,i.TEXTURE0+M)}let $t={[cc]:i.REPEAT,[ts]:i.CLAMP_TO_EDGE,[hc]:i.MIRRORED_REPEAT},le={[Nn]:i.NEAREST,[Vm]:i.NEAREST_MIPMAP_NEAREST,[Da]:i.NEAREST_MIPMAP_LINEAR,[Kn]:i.LINEAR,[Oc]:i.LINEAR_MIPMAP_NEAREST,[ws]:i.LINEAR_MIPMAP_LINEAR},Xt={[Xm]:i.NEVER,[vf]:i.ALWAYS,[qm]:i.LESS,[xf]:i.LEQUAL,[$m]:i.EQUAL,[yf]:i.GEQUAL,[Ym]:i.GREATER,[Zm]:i.NOTEQUAL};function me(I,M){if(M.type===Oi&&t.has("OES_texture_float_linear")===!1&&(M.magFilter===Kn||M.magFilter===Oc||M.magFilter===Da||M.magFilter===ws||M.minFilter===Kn||M.minFilter===Oc||M.minFilter===Da||M.minFilter===ws)&&jt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(I,i.TEXTURE_WRAP_S,$t[M.wrapS]),i.texParameteri(I,i.TEXTURE_WRAP_T,$t[M.wrapT]),(I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY)&&i.texParameteri(I,i.TEXTURE_WRAP_R,$t[M.wrapR]),i.texParameteri(I,i.TEXTURE_MAG_FILTER,le[M.magFilter]),i.texParameteri(I,i.TEXTURE_MIN_FILTER,le[M.minFilter]),M.compareFunction&&(i.texParameteri(I,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(I,i.TEXTURE_COMPARE_FUNC,Xt[M.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===Nn||M.minFilter!==Da&&M.minFilter!==ws||M.type===Oi&&t.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||n.get(M).__currentAnisotropy){let q=t.get("EXT_texture_filter_anisotropic");i.texParameterf(I,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),n.get(M).__currentAnisotropy=M.anisotropy}}}function fe(I,M){let q=!1;I.__webglInit===void 0&&(I.__webglInit=!0,M.addEventListener("dispose",A),O(M));let ut=M.source,at=d.get(ut);at===void 0&&(at={},d.set(ut,at));let yt=et(M);if(yt!==I.__cacheKey){at[yt]===void 0&&(at[yt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,q=!0),at[yt].usedTimes++;let St=at[I.__cacheKey];St!==void 0&&(at[I.__cacheKey].usedTimes--,St.usedTimes===0&&H(M)),I.__cacheKey=yt,I.__webglTexture=at[yt].texture}return q}function oe(I,M,q){return Math.floor(Math.floor(I/q)/M)}function Je(I,M,q,ut){let yt=I.updateRanges;if(yt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,M.width,M.height,q,ut,M.data);else{yt.sort((B,ot)=>B.start-ot.start);let St=0;for(let B=1;B<yt.length;B++){let ot=yt[St],st=yt[B],Et=ot.start+ot.count,xt=oe(st.start,M.width,4),bt=oe(ot.start,M.width,4);st.start<=Et+1&&xt===bt&&oe(st.start+st.count-1,M.width,4)===xt?ot.count=Math.max(ot.count,st.start+st.count-ot.start):(++St,yt[St]=st)}yt.length=St+1;let it=e.getParameter(i.UNPACK_ROW_LENGTH),rt=e.getParameter(i.UNPACK_SKIP_PIXELS),gt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,M.width);for(let B=0,ot=yt.length;B<ot;B++){let st=yt[B],Et=Math.floor(st.start/4),xt=Math.ceil(st.count/4),bt=Et%M.width,qt=Math.floor(Et/M.width),ee=xt,ht=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(i.UNPACK_SKIP_ROWS,qt),e.texSubImage2D(i.TEXTURE_2D,0,bt,qt,ee,ht,q,ut,M.data)}I.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,it),e.pixelStorei(i.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(i.UNPACK_SKIP_ROWS,gt)}}function He(I,M,q){let ut=i.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ut=i.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ut=i.TEXTURE_3D);let at=fe(I,M),yt=M.source;e.bindTexture(ut,I.__webglTexture,i.TEXTURE0+q);let St=n.get(yt);if(yt.version!==St.__version||at===!0){if(e.activeTexture(i.TEXTURE0+q),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ht=Se.getPrimaries(Se.workingColorSpace),zt=M.colorSpace===Es?null:Se.getPrimaries(M.colorSpace),ne=M.colorSpace===Es||ht===zt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne)}e.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment);let rt=v(M.image,!1,s.maxTextureSize);rt=Ht(M,rt);let gt=r.convert(M.format,M.colorSpace),B=r.convert(M.type),ot=E(M.internalFormat,gt,B,M.normalized,M.colorSpace,M.isVideoTexture);me(ut,M);let st,Et=M.mipmaps,xt=M.isVideoTexture!==!0,bt=St.__version===void 0||at===!0,qt=yt.dataReady,ee=b(M,rt);if(M.isDepthTexture)ot=_(M.format===Ts,M.type),bt&&(xt?e.texStorage2D(i.TEXTURE_2D,1,ot,rt.width,rt.height):e.texImage2D(i.TEXTURE_2D,0,ot,rt.width,rt.height,0,gt,B,null));else if(M.isDataTexture)if(Et.length>0){xt&&bt&&e.texStorage2D(i.TEXTURE_2D,ee,ot,Et[0].width,Et[0].height);for(let ht=0,zt=Et.length;ht<zt;ht++)st=Et[ht],xt?qt&&e.texSubImage2D(i.TEXTURE_2D,ht,0,0,st.width,st.height,gt,B,st.data):e.texImage2D(i.TEXTURE_2D,ht,ot,st.width,st.height,0,gt,B,st.data);M.generateMipmaps=!1}else xt?(bt&&e.texStorage2D(i.TEXTURE_2D,ee,ot,rt.width,rt.height),qt&&Je(M,rt,gt,B)):e.texImage2D(i.TEXTURE_2D,0,ot,rt.width,rt.height,0,gt,B,rt.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){xt&&bt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ee,ot,Et[0].width,Et[0].height,rt.depth);for(let ht=0,zt=Et.length;ht<zt;ht++)if(st=Et[ht],M.format!==ki)if(gt!==null)if(xt){if(qt)if(M.layerUpdates.size>0){let ne=If(st.width,st.height,M.format,M.type);for(let It of M.layerUpdates){let ue=st.data.subarray(It*ne/st.data.BYTES_PER_ELEMENT,(It+1)*ne/st.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ht,0,0,It,st.width,st.height,1,gt,ue)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ht,0,0,0,st.width,st.height,rt.depth,gt,st.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ht,ot,st.width,st.height,rt.depth,0,st.data,0,0);else jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xt?qt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ht,0,0,0,st.width,st.height,rt.depth,gt,B,st.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ht,ot,st.width,st.height,rt.depth,0,gt,B,st.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{xt&&bt&&e.texStorage2D(i.TEXTURE_2D,ee,ot,Et[0].width,Et[0].height);for(let ht=0,zt=Et.length;ht<zt;ht++)st=Et[ht],M.format!==ki?gt!==null?xt?qt&&e.compressedTexSubImage2D(i.TEXTURE_2D,ht,0,0,st.width,st.height,gt,st.data):e.compressedTexImage2D(i.TEXTURE_2D,ht,ot,st.width,st.height,0,st.data):jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xt?qt&&e.texSubImage2D(i.TEXTURE_2D,ht,0,0,st.width,st.height,gt,B,st.data):e.texImage2D(i.TEXTURE_2D,ht,ot,st.width,st.height,0,gt,B,st.data)}else if(M.isDataArrayTexture)if(xt){if(bt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ee,ot,rt.width,rt.height,rt.depth),qt)if(M.layerUpdates.size>0){let ht=If(rt.width,rt.height,M.format,M.type);for(let zt of M.layerUpdates){let ne=rt.data.subarray(zt*ht/rt.data.BYTES_PER_ELEMENT,(zt+1)*ht/rt.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,zt,rt.width,rt.height,1,gt,B,ne)}M.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,rt.width,rt.height,rt.depth,gt,B,rt.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,ot,rt.width,rt.height,rt.depth,0,gt,B,rt.data);else if(M.isData3DTexture)xt?(bt&&e.texStorage3D(i.TEXTURE_3D,ee,ot,rt.width,rt.height,rt.depth),qt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,rt.width,rt.height,rt.depth,gt,B,rt.data)):e.texImage3D(i.TEXTURE_3D,0,ot,rt.width,rt.height,rt.depth,0,gt,B,rt.data);else if(M.isFramebufferTexture){if(bt)if(xt)e.texStorage2D(i.TEXTURE_2D,ee,ot,rt.width,rt.height);else{let ht=rt.width,zt=rt.height;for(let ne=0;ne<ee;ne++)e.texImage2D(i.TEXTURE_2D,ne,ot,ht,zt,0,gt,B,null),ht>>=1,zt>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in i){let ht=i.canvas;if(ht.hasAttribute("layoutsubtree")||ht.setAttribute("layoutsubtree","true"),rt.parentNode!==ht){ht.appendChild(rt),u.add(M),ht.onpaint=zt=>{let ne=zt.changedElements;for(let It of u)ne.includes(It.image)&&(It.needsUpdate=!0)},ht.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,rt);else{let ne=i.RGBA,It=i.RGBA,ue=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,ne,It,ue,rt)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Et.length>0){if(xt&&bt){let ht=Kt(Et[0]);e.texStorage2D(i.TEXTURE_2D,ee,ot,ht.width,ht.height)}for(let ht=0,zt=Et.length;ht<zt;ht++)st=Et[ht],xt?qt&&e.texSubImage2D(i.TEXTURE_2D,ht,0,0,gt,B,st):e.texImage2D(i.TEXTURE_2D,ht,ot,gt,B,st);M.generateMipmaps=!1}else if(xt){if(bt){let ht=Kt(rt);e.texStorage2D(i.TEXTURE_2D,ee,ot,ht.width,ht.height)}qt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,gt,B,rt)}else e.texImage2D(i.TEXTURE_2D,0,ot,gt,B,rt);C(M)&&M.mipmapsAutoUpdate===!0&&S(ut),St.__version=yt.version,M.onUpdate&&M.onUpdate(M)}I.__version=M.version}function un(I,M,q){if(M.image.length!==6)return;let ut=fe(I,M),at=M.source;e.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+q);let yt=n.get(at);if(at.version!==yt.__version||ut===!0){e.activeTexture(i.TEXTURE0+q);let St=Se.getPrimaries(Se.workingColorSpace),it=M.colorSpace===Es?null:Se.getPrimaries(M.colorSpace),rt=M.colorSpace===Es||St===it?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,rt);let gt=M.isCompressedTexture||M.image[0].isCompressedTexture,B=M.image[0]&&M.image[0].isDataTexture,ot=[];for(let It=0;It<6;It++)!gt&&!B?ot[It]=v(M.image[It],!0,s.maxCubemapSize):ot[It]=B?M.image[It].image:M.image[It],ot[It]=Ht(M,ot[It]);let st=ot[0],Et=r.convert(M.format,M.colorSpace),xt=r.convert(M.type),bt=E(M.internalFormat,Et,xt,M.normalized,M.colorSpace),qt=M.isVideoTexture!==!0,ee=yt.__version===void 0||ut===!0,ht=at.dataReady,zt=b(M,st);me(i.TEXTURE_CUBE_MAP,M);let ne;if(M.isDepthTexture){if(bt=_(M.format===Ts,M.type),ee)if(qt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,bt,st.width,st.height);else for(let It=0;It<6;It++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,bt,st.width,st.height,0,Et,xt,null)}else if(gt){qt&&ee&&e.texStorage2D(i.TEXTURE_CUBE_MAP,zt,bt,st.width,st.height);for(let It=0;It<6;It++){ne=ot[It].mipmaps;for(let ue=0;ue<ne.length;ue++){let We=ne[ue];M.format!==ki?Et!==null?qt?ht&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,ue,0,0,We.width,We.height,Et,We.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,ue,bt,We.width,We.height,0,We.data):jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,ue,0,0,We.width,We.height,Et,xt,We.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,ue,bt,We.width,We.height,0,Et,xt,We.data)}}}else{if(ne=M.mipmaps,qt&&ee){ne.length>0&&zt++;let It=Kt(ot[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,zt,bt,It.width,It.height)}for(let It=0;It<6;It++)if(B){qt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,0,0,ot[It].width,ot[It].height,Et,xt,ot[It].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,bt,ot[It].width,ot[It].height,0,Et,xt,ot[It].data);for(let ue=0;ue<ne.length;ue++){let Hn=ne[ue].image[It].image;qt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,ue+1,0,0,Hn.width,Hn.height,Et,xt,Hn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,ue+1,bt,Hn.width,Hn.height,0,Et,xt,Hn.data)}}else{qt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,0,0,Et,xt,ot[It]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,bt,Et,xt,ot[It]);for(let ue=0;ue<ne.length;ue++){let We=ne[ue];qt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,ue+1,0,0,Et,xt,We.image[It]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,ue+1,bt,Et,xt,We.image[It])}}}C(M)&&M.mipmapsAutoUpdate===!0&&S(i.TEXTURE_CUBE_MAP),yt.__version=at.version,M.onUpdate&&M.onUpdate(M)}I.__version=M.version}function Be(I,M,q,ut,at,yt){let St=r.convert(q.format,q.colorSpace),it=r.convert(q.type),rt=E(q.internalFormat,St,it,q.normalized,q.colorSpace),gt=n.get(M),B=n.get(q);if(B.__renderTarget=M,!gt.__hasExternalTextures){let ot=Math.max(1,M.width>>yt),st=Math.max(1,M.height>>yt);at===i.TEXTURE_3D||at===i.TEXTURE_2D_ARRAY?e.texImage3D(at,yt,rt,ot,st,M.depth,0,St,it,null):e.texImage2D(at,yt,rt,ot,st,0,St,it,null)}e.bindFramebuffer(i.FRAMEBUFFER,I),Tt(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ut,at,B.__webglTexture,0,ce(M)):(at===i.TEXTURE_2D||at>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ut,at,B.__webglTexture,yt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Cn(I,M,q){if(i.bindRenderbuffer(i.RENDERBUFFER,I),M.depthBuffer){let ut=M.depthTexture,at=ut&&ut.isDepthTexture?ut.type:null,yt=_(M.stencilBuffer,at),St=M.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Tt(M)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ce(M),yt,M.width,M.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ce(M),yt,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,yt,M.width,M.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,St,i.RENDERBUFFER,I)}else{let ut=M.textures;for(let at=0;at<ut.length;at++){let yt=ut[at],St=r.convert(yt.format,yt.colorSpace),it=r.convert(yt.type),rt=E(yt.internalFormat,St,it,yt.normalized,yt.colorSpace);Tt(M)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ce(M),rt,M.width,M.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ce(M),rt,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,rt,M.width,M.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function be(I,M,q){let ut=M.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,I),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=n.get(M.depthTexture);at.__renderTarget=M;let yt=ut?M.depthTexture.image[0]:M.depthTexture.image;(!at.__webglTexture||yt.width!==M.width||yt.height!==M.height)&&(yt.width=M.width,yt.height=M.height,M.depthTexture.needsUpdate=!0),ut?wt(M.depthTexture,0):_t(M.depthTexture,0);let St=at.__webglTexture,it=ce(M),rt=ut?i.TEXTURE_CUBE_MAP_POSITIVE_X+q:i.TEXTURE_2D,gt=M.depthTexture.format===Ts?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(M.depthTexture.format===Ss)Tt(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,gt,rt,St,0,it):i.framebufferTexture2D(i.FRAMEBUFFER,gt,rt,St,0);else if(M.depthTexture.format===Ts)Tt(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,gt,rt,St,0,it):i.framebufferTexture2D(i.FRAMEBUFFER,gt,rt,St,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function yn(I){let M=n.get(I),q=I.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==I.depthTexture){let ut=I.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ut){let at=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ut.removeEventListener("dispose",at)};ut.addEventListener("dispose",at),M.__depthDisposeCallback=at}M.__boundDepthTexture=ut}if(I.depthTexture&&!M.__autoAllocateDepthBuffer)if(q)for(let ut=0;ut<6;ut++)be(M.__webglFramebuffer[ut],I,ut);else I.texture.mipmaps.length>0?be(M.__webglFramebuffer[0],I,0):be(M.__webglFramebuffer,I,0);else if(q){M.__webglDepthbuffer=[];for(let ut=0;ut<6;ut++)if(e.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[ut]),M.__webglDepthbuffer[ut]===void 0)M.__webglDepthbuffer[ut]=i.createRenderbuffer(),Cn(M.__webglDepthbuffer[ut],I,!1);else{let at=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=M.__webglDepthbuffer[ut];i.bindRenderbuffer(i.RENDERBUFFER,yt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,yt)}}else if(I.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=i.createRenderbuffer(),Cn(M.__webglDepthbuffer,I,!1);else{let at=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=M.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,yt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,yt)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function nn(I,M,q){let ut=n.get(I);M!==void 0&&Be(ut.__webglFramebuffer,I,I.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),q!==void 0&&yn(I)}function fn(I){let M=I.texture,q=n.get(I),ut=n.get(M);I.addEventListener("dispose",F),O(I);let at=I.textures,yt=I.isWebGLCubeRenderTarget===!0,St=at.length>1;if(St||(ut.__webglTexture===void 0&&(ut.__webglTexture=i.createTexture()),ut.__version=M.version,o.memory.textures++),yt){q.__webglFramebuffer=[];for(let it=0;it<6;it++)if(M.mipmaps.length>0){q.__webglFramebuffer[it]=[];for(let rt=0;rt<M.mipmaps.length;rt++)q.__webglFramebuffer[it][rt]=i.createFramebuffer()}else q.__webglFramebuffer[it]=i.createFramebuffer()}else{if(M.mipmaps.length>0){q.__webglFramebuffer=[];for(let it=0;it<M.mipmaps.length;it++)q.__webglFramebuffer[it]=i.createFramebuffer()}else q.__webglFramebuffer=i.createFramebuffer();if(St)for(let it=0,rt=at.length;it<rt;it++){let gt=n.get(at[it]);gt.__webglTexture===void 0&&(gt.__webglTexture=i.createTexture(),o.memory.textures++)}if(I.samples>0&&Tt(I)===!1){q.__webglMultisampledFramebuffer=i.createFramebuffer(),q.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let it=0;it<at.length;it++){let rt=at[it];q.__webglColorRenderbuffer[it]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,q.__webglColorRenderbuffer[it]);let gt=r.convert(rt.format,rt.colorSpace),B=r.convert(rt.type),ot=E(rt.internalFormat,gt,B,rt.normalized,rt.colorSpace,I.isXRRenderTarget===!0),st=ce(I);i.renderbufferStorageMultisample(i.RENDERBUFFER,st,ot,I.width,I.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+it,i.RENDERBUFFER,q.__webglColorRenderbuffer[it])}i.bindRenderbuffer(i.RENDERBUFFER,null),I.depthBuffer&&(q.__webglDepthRenderbuffer=i.createRenderbuffer(),Cn(q.__webglDepthRenderbuffer,I,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(yt){e.bindTexture(i.TEXTURE_CUBE_MAP,ut.__webglTexture),me(i.TEXTURE_CUBE_MAP,M);for(let it=0;it<6;it++)if(M.mipmaps.length>0)for(let rt=0;rt<M.mipmaps.length;rt++)Be(q.__webglFramebuffer[it][rt],I,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+it,rt);else Be(q.__webglFramebuffer[it],I,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+it,0);C(M)?S(i.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),e.unbindTexture()}else if(St){for(let it=0,rt=at.length;it<rt;it++){let gt=at[it],B=n.get(gt),ot=i.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(ot=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(ot,B.__webglTexture),me(ot,gt),Be(q.__webglFramebuffer,I,gt,i.COLOR_ATTACHMENT0+it,ot,0),C(gt)&&S(ot)}e.unbindTexture()}else{let it=i.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(it=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(it,ut.__webglTexture),me(it,M),M.mipmaps.length>0)for(let rt=0;rt<M.mipmaps.length;rt++)Be(q.__webglFramebuffer[rt],I,M,i.COLOR_ATTACHMENT0,it,rt);else Be(q.__webglFramebuffer,I,M,i.COLOR_ATTACHMENT0,it,0);C(M)?S(it):M.mipmaps.length>0&&i.texParameteri(it,i.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),e.unbindTexture()}I.depthBuffer&&yn(I)}function k(I){let M=I.textures;for(let q=0,ut=M.length;q<ut;q++){let at=M[q];if(C(at)&&at.mipmapsAutoUpdate===!0){let yt=P(I),St=n.get(at).__webglTexture;e.bindTexture(yt,St),S(yt),e.unbindTexture()}}}let Lt=[];function Qt(I){if(I.samples>0){if(Tt(I)===!1){let M=I.textures,q=I.width,ut=I.height,at=i.COLOR_BUFFER_BIT,yt=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,St=n.get(I),it=M.length>1;if(it)for(let gt=0;gt<M.length;gt++)e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let gt=0;gt<M.length;gt++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(at|=i.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(at|=i.STENCIL_BUFFER_BIT)),it){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,St.__webglColorRenderbuffer[gt]);let B=n.get(M[gt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,B,0)}i.blitFramebuffer(0,0,q,ut,0,0,q,ut,at,i.NEAREST),l===!0&&(Lt.length=0,Lt.push(i.COLOR_ATTACHMENT0+gt),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&Lt.push(yt),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Lt))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),it)for(let gt=0;gt<M.length;gt++){e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.RENDERBUFFER,St.__webglColorRenderbuffer[gt]);let B=n.get(M[gt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.TEXTURE_2D,B,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&l){let M=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[M])}}}function ce(I){return Math.min(s.maxSamples,I.samples)}function Tt(I){let M=n.get(I);return I.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function ze(I){let M=o.render.frame;h.get(I)!==M&&(h.set(I,M),I.update())}function Ht(I,M){let q=I.colorSpace,ut=I.format,at=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||q!==ra&&q!==Es&&(Se.getTransfer(q)===Le?(ut!==ki||at!==ri)&&jt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ie("WebGLTextures: Unsupported texture color space:",q)),M}function Kt(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=ft,this.resetTextureUnits=tt,this.getTextureUnits=nt,this.setTextureUnits=pt,this.setTexture2D=_t,this.setTexture2DArray=vt,this.setTexture3D=Pt,this.setTextureCube=wt,this.rebindTextures=nn,this.setupRenderTarget=fn,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=Qt,this.setupDepthRenderbuffer=yn,this.setupFrameBufferTexture=Be,this.useMultisampledRTT=Tt,this.dispose=V}function jw(i,t){function e(n,s=Es){let r,o=Se.getTransfer(s);if(n===ri)return i.UNSIGNED_BYTE;if(n===kc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===zc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===df)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===pf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===uf)return i.BYTE;if(n===ff)return i.SHORT;if(n===Mo)return i.UNSIGNED_SHORT;if(n===Bc)return i.INT;if(n===Fi)return i.UNSIGNED_INT;if(n===Oi)return i.FLOAT;if(n===Bi)return i.HALF_FLOAT;if(n===mf)return i.ALPHA;if(n===gf)return i.RGB;if(n===ki)return i.RGBA;if(n===Ss)return i.DEPTH_COMPONENT;if(n===Ts)return i.DEPTH_STENCIL;if(n===_f)return i.RED;if(n===Vc)return i.RED_INTEGER;if(n===Zs)return i.RG;if(n===Gc)return i.RG_INTEGER;if(n===Hc)return i.RGBA_INTEGER;if(n===Na||n===Ua||n===Fa||n===Oa)if(o===Le)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Na)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ua)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Fa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Oa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Na)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ua)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Fa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Oa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Wc||n===Xc||n===qc||n===$c)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Wc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Xc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===qc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===$c)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Yc||n===Zc||n===Jc||n===Kc||n===jc||n===Ba||n===Qc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Yc||n===Zc)return o===Le?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Jc)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Kc)return r.COMPRESSED_R11_EAC;if(n===jc)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ba)return r.COMPRESSED_RG11_EAC;if(n===Qc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===th||n===eh||n===nh||n===ih||n===sh||n===rh||n===oh||n===ah||n===lh||n===ch||n===hh||n===uh||n===fh||n===dh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===th)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===eh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===nh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===ih)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===sh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===rh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===oh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===ah)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===lh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===ch)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===hh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===uh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===fh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===dh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===ph||n===mh||n===gh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===ph)return o===Le?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===mh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===gh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===_h||n===xh||n===ka||n===yh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===_h)return r.COMPRESSED_RED_RGTC1_EXT;if(n===xh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===ka)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===yh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===xr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var Qw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,tT=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,zf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new ya(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new ss({vertexShader:Qw,fragmentShader:tT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Mn(new Sa(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Vf=class extends Ui{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,d=null,m=null,y=typeof XRWebGLBinding<"u",p=new zf,g={},v=e.getContextAttributes(),C=null,S=null,P=[],E=[],_=new Zt,b=null,O=null,D=new Jn;D.viewport=new je;let A=new Jn;A.viewport=new je;let F=[D,A],G=new Nc,N=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(et){let _t=P[et];return _t===void 0&&(_t=new fo,P[et]=_t),_t.getTargetRaySpace()},this.getControllerGrip=function(et){let _t=P[et];return _t===void 0&&(_t=new fo,P[et]=_t),_t.getGripSpace()},this.getHand=function(et){let _t=P[et];return _t===void 0&&(_t=new fo,P[et]=_t),_t.getHandSpace()};function $(et){let _t=E.indexOf(et.inputSource);if(_t===-1)return;let vt=P[_t];vt!==void 0&&(vt.update(et.inputSource,et.frame,c||o),vt.dispatchEvent({type:et.type,data:et.inputSource}))}function H(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",ct);for(let et=0;et<P.length;et++){let _t=E[et];_t!==null&&(E[et]=null,P[et].disconnect(_t))}N=null,V=null,p.reset();for(let et in g)delete g[et];if(t.setRenderTarget(C),d=null,f=null,u=null,s=null,S=null,ft.stop(),n.isPresenting=!1,t.setPixelRatio(b),t.setSize(_.width,_.height,!1),O!==null){let et=O.camera;et.fov=O.fov,et.zoom=O.zoom,et.updateProjectionMatrix(),O=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(et){r=et,n.isPresenting===!0&&jt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(et){a=et,n.isPresenting===!0&&jt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(et){c=et},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return u===null&&y&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(et){if(s=et,s!==null){if(C=t.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",H),s.addEventListener("inputsourceschange",ct),v.xrCompatible!==!0&&await e.makeXRCompatible(),b=t.getPixelRatio(),t.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let vt=null,Pt=null,wt=null;v.depth&&(wt=v.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,vt=v.stencil?Ts:Ss,Pt=v.stencil?xr:Fi);let $t={colorFormat:e.RGBA8,depthFormat:wt,scaleFactor:r};u=this.getBinding(),f=u.createProjectionLayer($t),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),S=new pi(f.textureWidth,f.textureHeight,{format:ki,type:ri,depthTexture:new bs(f.textureWidth,f.textureHeight,Pt,void 0,void 0,void 0,void 0,void 0,void 0,vt),stencilBuffer:v.stencil,colorSpace:t.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let vt={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,vt),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),S=new pi(d.framebufferWidth,d.framebufferHeight,{format:ki,type:ri,colorSpace:t.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ft.setContext(s),ft.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function ct(et){for(let _t=0;_t<et.removed.length;_t++){let vt=et.removed[_t],Pt=E.indexOf(vt);Pt>=0&&(E[Pt]=null,P[Pt].disconnect(vt))}for(let _t=0;_t<et.added.length;_t++){let vt=et.added[_t],Pt=E.indexOf(vt);if(Pt===-1){for(let $t=0;$t<P.length;$t++)if($t>=E.length){E.push(vt),Pt=$t;break}else if(E[$t]===null){E[$t]=vt,Pt=$t;break}if(Pt===-1)break}let wt=P[Pt];wt&&wt.connect(vt)}}function K(et,_t){_t===null?et.matrixWorld.copy(et.matrix):et.matrixWorld.multiplyMatrices(_t.matrixWorld,et.matrix),et.matrixWorldInverse.copy(et.matrixWorld).invert()}this.updateCamera=function(et){if(s===null)return;let _t=et.near,vt=et.far;p.texture!==null&&(p.depthNear>0&&(_t=p.depthNear),p.depthFar>0&&(vt=p.depthFar)),G.near=A.near=D.near=_t,G.far=A.far=D.far=vt,(N!==G.near||V!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),N=G.near,V=G.far),G.layers.mask=et.layers.mask|6,D.layers.mask=G.layers.mask&-5,A.layers.mask=G.layers.mask&-3;let Pt=et.parent,wt=G.cameras;K(G,Pt);for(let $t=0;$t<wt.length;$t++)K(wt[$t],Pt);G.projectionMatrix.copy(D.projectionMatrix),G.projectionMatrixInverse.copy(D.projectionMatrixInverse),O===null&&et.isPerspectiveCamera&&(O={camera:et,fov:et.fov,zoom:et.zoom}),tt(et,G,Pt)};function tt(et,_t,vt){vt===null?et.matrix.copy(_t.matrixWorld):(et.matrix.copy(vt.matrixWorld),et.matrix.invert(),et.matrix.multiply(_t.matrixWorld)),et.matrix.decompose(et.position,et.quaternion,et.scale),et.updateMatrixWorld(!0),et.projectionMatrix.copy(_t.projectionMatrix),et.projectionMatrixInverse.copy(_t.projectionMatrixInverse),et.isPerspectiveCamera&&(et.fov=ho*2*Math.atan(1/et.projectionMatrix.elements[5]),et.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(et){l=et,f!==null&&(f.fixedFoveation=et),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=et)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(G)},this.getCameraTexture=function(et){return g[et]};let nt=null;function pt(et,_t){if(h=_t.getViewerPose(c||o),m=_t,h!==null){let vt=h.views;d!==null&&(t.setRenderTargetFramebuffer(S,d.framebuffer),t.setRenderTarget(S));let Pt=!1;vt.length!==G.cameras.length&&(G.cameras.length=0,Pt=!0);for(let Xt=0;Xt<vt.length;Xt++){let me=vt[Xt],fe=null;if(d!==null)fe=d.getViewport(me);else{let Je=u.getViewSubImage(f,me);fe=Je.viewport,Xt===0&&(t.setRenderTargetTextures(S,Je.colorTexture,Je.depthStencilTexture),t.setRenderTarget(S))}let oe=F[Xt];oe===void 0&&(oe=new Jn,oe.layers.enable(Xt),oe.viewport=new je,F[Xt]=oe),oe.matrix.fromArray(me.transform.matrix),oe.matrix.decompose(oe.position,oe.quaternion,oe.scale),oe.projectionMatrix.fromArray(me.projectionMatrix),oe.projectionMatrixInverse.copy(oe.projectionMatrix).invert(),oe.viewport.set(fe.x,fe.y,fe.width,fe.height),Xt===0&&(G.matrix.copy(oe.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Pt===!0&&G.cameras.push(oe)}let wt=s.enabledFeatures;if(wt&&wt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){u=n.getBinding();let Xt=u.getDepthInformation(vt[0]);Xt&&Xt.isValid&&Xt.texture&&p.init(Xt,s.renderState)}if(wt&&wt.includes("camera-access")&&y){t.state.unbindTexture(),u=n.getBinding();for(let Xt=0;Xt<vt.length;Xt++){let me=vt[Xt].camera;if(me){let fe=g[me];fe||(fe=new ya,g[me]=fe);let oe=u.getCameraImage(me);fe.sourceTexture=oe}}}}for(let vt=0;vt<P.length;vt++){let Pt=E[vt],wt=P[vt];Pt!==null&&wt!==void 0&&wt.update(Pt,_t,c||o)}nt&&nt(et,_t),_t.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:_t}),m=null}let ft=new Eg;ft.setAnimationLoop(pt),this.setAnimationLoop=function(et){nt=et},this.dispose=function(){}}},eT=new De,Fg=new re;Fg.set(-1,0,0,0,1,0,0,0,1);function nT(i,t){function e(p,g){p.matrixAutoUpdate===!0&&p.updateMatrix(),g.value.copy(p.matrix)}function n(p,g){g.color.getRGB(p.fogColor.value,Cf(i)),g.isFog?(p.fogNear.value=g.near,p.fogFar.value=g.far):g.isFogExp2&&(p.fogDensity.value=g.density)}function s(p,g,v,C,S){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(p,g):g.isMeshLambertMaterial?(r(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(p,g),u(p,g)):g.isMeshPhongMaterial?(r(p,g),h(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(p,g),f(p,g),g.isMeshPhysicalMaterial&&d(p,g,S)):g.isMeshMatcapMaterial?(r(p,g),m(p,g)):g.isMeshDepthMaterial?r(p,g):g.isMeshDistanceMaterial?(r(p,g),y(p,g)):g.isMeshNormalMaterial?r(p,g):g.isLineBasicMaterial?(o(p,g),g.isLineDashedMaterial&&a(p,g)):g.isPointsMaterial?l(p,g,v,C):g.isSpriteMaterial?c(p,g):g.isShadowMaterial?(p.color.value.copy(g.color),p.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(p,g){p.opacity.value=g.opacity,g.color&&p.diffuse.value.copy(g.color),g.emissive&&p.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(p.map.value=g.map,e(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.bumpMap&&(p.bumpMap.value=g.bumpMap,e(g.bumpMap,p.bumpMapTransform),p.bumpScale.value=g.bumpScale,g.side===ti&&(p.bumpScale.value*=-1)),g.normalMap&&(p.normalMap.value=g.normalMap,e(g.normalMap,p.normalMapTransform),p.normalScale.value.copy(g.normalScale),g.side===ti&&p.normalScale.value.negate()),g.displacementMap&&(p.displacementMap.value=g.displacementMap,e(g.displacementMap,p.displacementMapTransform),p.displacementScale.value=g.displacementScale,p.displacementBias.value=g.displacementBias),g.emissiveMap&&(p.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,p.emissiveMapTransform)),g.specularMap&&(p.specularMap.value=g.specularMap,e(g.specularMap,p.specularMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest);let v=t.get(g),C=v.envMap,S=v.envMapRotation;C&&(p.envMap.value=C,p.envMapRotation.value.setFromMatrix4(eT.makeRotationFromEuler(S)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Fg),p.reflectivity.value=g.reflectivity,p.ior.value=g.ior,p.refractionRatio.value=g.refractionRatio),g.lightMap&&(p.lightMap.value=g.lightMap,p.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,p.lightMapTransform)),g.aoMap&&(p.aoMap.value=g.aoMap,p.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,p.aoMapTransform))}function o(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,g.map&&(p.map.value=g.map,e(g.map,p.mapTransform))}function a(p,g){p.dashSize.value=g.dashSize,p.totalSize.value=g.dashSize+g.gapSize,p.scale.value=g.scale}function l(p,g,v,C){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.size.value=g.size*v,p.scale.value=C*.5,g.map&&(p.map.value=g.map,e(g.map,p.uvTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function c(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.rotation.value=g.rotation,g.map&&(p.map.value=g.map,e(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function h(p,g){p.specular.value.copy(g.specular),p.shininess.value=Math.max(g.shininess,1e-4)}function u(p,g){g.gradientMap&&(p.gradientMap.value=g.gradientMap)}function f(p,g){p.metalness.value=g.metalness,g.metalnessMap&&(p.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,p.metalnessMapTransform)),p.roughness.value=g.roughness,g.roughnessMap&&(p.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,p.roughnessMapTransform)),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)}function d(p,g,v){p.ior.value=g.ior,g.diffuseRoughness>0&&(p.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),g.sheen>0&&(p.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),p.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(p.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,p.sheenColorMapTransform)),g.sheenRoughnessMap&&(p.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,p.sheenRoughnessMapTransform))),g.clearcoat>0&&(p.clearcoat.value=g.clearcoat,p.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(p.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,p.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(p.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===ti&&p.clearcoatNormalScale.value.negate())),g.dispersion>0&&(p.dispersion.value=g.dispersion),g.retroreflectivity>0&&(p.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(p.iridescence.value=g.iridescence,p.iridescenceIOR.value=g.iridescenceIOR,p.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(p.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,p.iridescenceMapTransform)),g.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),g.transmission>0&&(p.transmission.value=g.transmission,p.transmissionSamplerMap.value=v.texture,p.transmissionSamplerSize.value.set(v.width,v.height),g.transmissionMap&&(p.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,p.transmissionMapTransform)),p.thickness.value=g.thickness,g.thicknessMap&&(p.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=g.attenuationDistance,p.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(p.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(p.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=g.specularIntensity,p.specularColor.value.copy(g.specularColor),g.specularColorMap&&(p.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,p.specularColorMapTransform)),g.specularIntensityMap&&(p.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,p.specularIntensityMapTransform))}function m(p,g){g.matcap&&(p.matcap.value=g.matcap)}function y(p,g){let v=t.get(g).light;p.referencePosition.value.setFromMatrixPosition(v.matrixWorld),p.nearDistance.value=v.shadow.camera.near,p.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function iT(i,t,e,n){let s={},r={};function o(v,C){let S=C.program;n.uniformBlockBinding(v,S,s[v.id])}function a(v,C){let S=s[v.id];S===void 0&&(m(v),S=l(v),s[v.id]=S,v.addEventListener("dispose",p));let P=C.program;n.updateUBOMapping(v,P);let E=t.render.frame;r[v.id]!==E&&(c(v),r[v.id]=E)}function l(v){let C=i.createBuffer(),S=v.__size,P=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,C),i.bufferData(i.UNIFORM_BUFFER,S,P),i.bindBuffer(i.UNIFORM_BUFFER,null),C}function c(v){let C=s[v.id],S=v.uniforms,P=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,C);for(let E=0,_=S.length;E<_;E++){let b=S[E];if(Array.isArray(b))for(let O=0,D=b.length;O<D;O++)h(b[O],E,O,P);else h(b,E,0,P)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(v,C,S,P){if(f(v,C,S,P)===!0){let E=v.__offset,_=v.value;if(Array.isArray(_)){let b=0;for(let O=0;O<_.length;O++){let D=_[O],A=y(D,!0);u(D,v.__data,b),b+=A.storage/Float32Array.BYTES_PER_ELEMENT}}else u(_,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,v.__data)}}function u(v,C,S){typeof v=="number"||typeof v=="boolean"?C[S]=v:v.isMatrix3?(C[S]=v.elements[0],C[S+1]=v.elements[1],C[S+2]=v.elements[2],C[S+3]=0,C[S+4]=v.elements[3],C[S+5]=v.elements[4],C[S+6]=v.elements[5],C[S+7]=0,C[S+8]=v.elements[6],C[S+9]=v.elements[7],C[S+10]=v.elements[8],C[S+11]=0):ArrayBuffer.isView(v)?C.set(v.subarray(0,C.length-S),S):v.toArray(C,S)}function f(v,C,S,P){let E=v.value,_=C+"_"+S;if(Array.isArray(E)){P[_]===void 0&&(P[_]=[]);let b=P[_],O=!1;for(let D=0;D<E.length;D++)d(E[D],b,D)===!0&&(O=!0);return O}return d(E,P,_)}function d(v,C,S){if(C[S]===void 0)return typeof v=="number"||typeof v=="boolean"?C[S]=v:ArrayBuffer.isView(v)?C[S]=v.slice():C[S]=v.clone(),!0;{let P=C[S];if(typeof v=="number"||typeof v=="boolean"){if(P!==v)return C[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(P.equals(v)===!1)return P.copy(v),!0}}return!1}function m(v){let C=v.uniforms,S=0,P=16;for(let _=0,b=C.length;_<b;_++){let O=Array.isArray(C[_])?C[_]:[C[_]];for(let D=0,A=O.length;D<A;D++){let F=O[D],G=Array.isArray(F.value)?F.value:[F.value],N=Array.isArray(C[_])||Array.isArray(F.value),V=S;for(let H=0,ct=G.length;H<ct;H++){let K=G[H],tt=y(K,N),nt=S%P,pt=nt%tt.boundary,ft=nt+pt;S+=pt,ft!==0&&P-ft<tt.storage&&(S+=P-ft),H===0&&(V=S),S+=tt.storage}let $=F.type==="int"?Int32Array:F.type==="uint"?Uint32Array:Float32Array;F.__data=new $((S-V)/Float32Array.BYTES_PER_ELEMENT),F.__offset=V}}let E=S%P;return E>0&&(S+=P-E),v.__size=S,v.__cache={},this}function y(v,C){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?jt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):jt("WebGLRenderer: Unsupported uniform value type.",v),C===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function p(v){let C=v.target;C.removeEventListener("dispose",p),i.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function g(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:g}}var sT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),as=null;function rT(){return as===null&&(as=new gc(sT,16,16,Zs,Bi),as.name="DFG_LUT",as.minFilter=Kn,as.magFilter=Kn,as.wrapS=ts,as.wrapT=ts,as.generateMipmaps=!1,as.needsUpdate=!0),as}var Th=class{constructor(t={}){let{canvas:e=Jm(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:f=!1,outputBufferType:d=ri}=t;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;let y=d,p=new Set([Hc,Gc,Vc]),g=new Set([ri,Fi,Mo,xr,kc,zc]),v=new Uint32Array(4),C=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},P=null,E=null,_=[],b=[],O=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=os,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let D=this,A=!1,F=null,G=null,N=null,V=null;this._outputColorSpace=Zn;let $=0,H=0,ct=null,K=-1,tt=null,nt=new je,pt=new je,ft=null,et=new he(0),_t=0,vt=e.width,Pt=e.height,wt=1,$t=null,le=null,Xt=new je(0,0,vt,Pt),me=new je(0,0,vt,Pt),fe=!1,oe=new Gs,Je=new _c,He=!1,un=!1,Be=new De,Cn=new X,be=new je,yn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},nn=!1;function fn(){return ct===null?wt:1}let k=n;function Lt(T,z){return e.getContext(T,z)}let Qt,ce,Tt,ze,Ht,Kt,I,M,q,ut,at,yt,St,it,rt,gt,B,ot,st,Et,xt,bt,qt;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",zt,!1),e.addEventListener("webglcontextrestored",ne,!1),e.addEventListener("webglcontextcreationerror",It,!1),k===null){let z="webgl2";if(k=Lt(z,T),k===null)throw Lt(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ee()}catch(T){throw e.removeEventListener("webglcontextlost",zt,!1),e.removeEventListener("webglcontextrestored",ne,!1),e.removeEventListener("webglcontextcreationerror",It,!1),ie("WebGLRenderer: "+T.message),T}function ee(){Qt=new gb(k),Qt.init(),xt=new jw(k,Qt),ce=new rb(k,Qt,t,xt),Tt=new Jw(k,Qt),ce.reversedDepthBuffer&&f&&Tt.buffers.depth.setReversed(!0),G=k.createFramebuffer(),N=k.createFramebuffer(),V=k.createFramebuffer(),ze=new yb(k),Ht=new Fw,Kt=new Kw(k,Qt,Tt,Ht,ce,xt,ze),I=new mb(D),M=new Sv(k),bt=new ib(k,M),q=new _b(k,M,ze,bt),ut=new Sb(k,q,M,bt,ze),ot=new vb(k,ce,Kt),rt=new ob(Ht),at=new Uw(D,I,Qt,ce,bt,rt),yt=new nT(D,Ht),St=new Bw,it=new Ww(Qt),B=new nb(D,I,Tt,ut,m,l),gt=new Zw(D,ut,ce),qt=new iT(k,ze,ce,Tt),st=new sb(k,Qt,ze),Et=new xb(k,Qt,ze),ze.programs=at.programs,D.capabilities=ce,D.extensions=Qt,D.properties=Ht,D.renderLists=St,D.shadowMap=gt,D.state=Tt,D.info=ze}y!==ri&&(O=new bb(y,e.width,e.height,a,s,r));let ht=new Vf(D,k);this.xr=ht,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let T=Qt.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=Qt.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return wt},this.setPixelRatio=function(T){T!==void 0&&(wt=T,this.setSize(vt,Pt,!1))},this.getSize=function(T){return T.set(vt,Pt)},this.setSize=function(T,z,Q=!0){if(ht.isPresenting){jt("WebGLRenderer: Can't change size while VR device is presenting.");return}vt=T,Pt=z,e.width=Math.floor(T*wt),e.height=Math.floor(z*wt),Q===!0&&(e.style.width=T+"px",e.style.height=z+"px"),O!==null&&O.setSize(e.width,e.height),this.setViewport(0,0,T,z)},this.getDrawingBufferSize=function(T){return T.set(vt*wt,Pt*wt).floor()},this.setDrawingBufferSize=function(T,z,Q){vt=T,Pt=z,wt=Q,e.width=Math.floor(T*Q),e.height=Math.floor(z*Q),this.setViewport(0,0,T,z)},this.setEffects=function(T){if(y===ri){ie("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let z=0;z<T.length;z++)if(T[z].isOutputPass===!0){jt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}O.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(nt)},this.getViewport=function(T){return T.copy(Xt)},this.setViewport=function(T,z,Q,Y){T.isVector4?Xt.set(T.x,T.y,T.z,T.w):Xt.set(T,z,Q,Y),Tt.viewport(nt.copy(Xt).multiplyScalar(fn()).round())},this.getScissor=function(T){return T.copy(me)},this.setScissor=function(T,z,Q,Y){T.isVector4?me.set(T.x,T.y,T.z,T.w):me.set(T,z,Q,Y),Tt.scissor(pt.copy(me).multiplyScalar(fn()).round())},this.getScissorTest=function(){return fe},this.setScissorTest=function(T){Tt.setScissorTest(fe=T)},this.setOpaqueSort=function(T){$t=T},this.setTransparentSort=function(T){le=T},this.getClearColor=function(T){return T.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(T=!0,z=!0,Q=!0){let Y=0;if(T){let Z=!1;if(ct!==null){let At=ct.texture.format;Z=p.has(At)}if(Z){let At=ct.texture.type,Dt=g.has(At),Ct=B.getClearColor(),Nt=B.getClearAlpha(),Gt=Ct.r,se=Ct.g,ge=Ct.b;Dt?(v[0]=Gt,v[1]=se,v[2]=ge,v[3]=Nt,k.clearBufferuiv(k.COLOR,0,v)):(C[0]=Gt,C[1]=se,C[2]=ge,C[3]=Nt,k.clearBufferiv(k.COLOR,0,C))}else Y|=k.COLOR_BUFFER_BIT}z&&(Y|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(Y|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&k.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),F=T},this.dispose=function(){e.removeEventListener("webglcontextlost",zt,!1),e.removeEventListener("webglcontextrestored",ne,!1),e.removeEventListener("webglcontextcreationerror",It,!1),B.dispose(),St.dispose(),it.dispose(),Kt.dispose(),Ht.dispose(),I.dispose(),ut.dispose(),q.dispose(),bt.dispose(),qt.dispose(),at.dispose(),ht.dispose(),ht.removeEventListener("sessionstart",Qa),ht.removeEventListener("sessionend",Wi),hs.stop()};function zt(T){T.preventDefault(),la("WebGLRenderer: Context Lost."),A=!0}function ne(){la("WebGLRenderer: Context Restored."),A=!1;let T=ze.autoReset,z=gt.enabled,Q=gt.autoUpdate,Y=gt.needsUpdate,Z=gt.type;ee(),ze.autoReset=T,gt.enabled=z,gt.autoUpdate=Q,gt.needsUpdate=Y,gt.type=Z}function It(T){ie("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function ue(T){let z=T.target;z.removeEventListener("dispose",ue),We(z)}function We(T){Hn(T),Ht.remove(T)}function Hn(T){let z=Ht.get(T).programs;z!==void 0&&(z.forEach(function(Q){at.releaseProgram(Q)}),T.isShaderMaterial&&at.releaseShaderCache(T))}this.renderBufferDirect=function(T,z,Q,Y,Z,At){z===null&&(z=yn);let Dt=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Ct=ko(T,z,Q,Y,Z);Tt.setMaterial(Y,Dt);let Nt=Q.index,Gt=1;if(Y.wireframe===!0){if(Nt=q.getWireframeAttribute(Q),Nt===void 0)return;Gt=2}let se=Q.drawRange,ge=Q.attributes.position,Vt=se.start*Gt,_e=(se.start+se.count)*Gt;At!==null&&(Vt=Math.max(Vt,At.start*Gt),_e=Math.min(_e,(At.start+At.count)*Gt)),Nt!==null?(Vt=Math.max(Vt,0),_e=Math.min(_e,Nt.count)):ge!=null&&(Vt=Math.max(Vt,0),_e=Math.min(_e,ge.count));let Qe=_e-Vt;if(Qe<0||Qe===1/0)return;bt.setup(Z,Y,Ct,Q,Nt);let Ue,Fe=st;if(Nt!==null&&(Ue=M.get(Nt),Fe=Et,Fe.setIndex(Ue)),Z.isMesh)Y.wireframe===!0?(Tt.setLineWidth(Y.wireframeLinewidth*fn()),Fe.setMode(k.LINES)):Fe.setMode(k.TRIANGLES);else if(Z.isLine){let vn=Y.linewidth;vn===void 0&&(vn=1),Tt.setLineWidth(vn*fn()),Z.isLineSegments?Fe.setMode(k.LINES):Z.isLineLoop?Fe.setMode(k.LINE_LOOP):Fe.setMode(k.LINE_STRIP)}else Z.isPoints?Fe.setMode(k.POINTS):Z.isSprite&&Fe.setMode(k.TRIANGLES);if(Z.isBatchedMesh)if(Qt.get("WEBGL_multi_draw"))Fe.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let vn=Z._multiDrawStarts,Bt=Z._multiDrawCounts,dn=Z._multiDrawCount,ve=Nt?M.get(Nt).bytesPerElement:1,fs=Ht.get(Y).currentProgram.getUniforms();for(let pn=0;pn<dn;pn++)fs.setValue(k,"_gl_DrawID",pn),Fe.render(vn[pn]/ve,Bt[pn])}else if(Z.isInstancedMesh)Fe.renderInstances(Vt,Qe,Z.count);else if(Q.isInstancedBufferGeometry){let vn=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Bt=Math.min(Q.instanceCount,vn);Fe.renderInstances(Vt,Qe,Bt)}else Fe.render(Vt,Qe)};function Fo(T,z,Q,Y){F!==null&&T.isNodeMaterial&&F.setObject(Y,T),He===!0&&rt.setState(T,Q,!1),T.transparent===!0&&T.side===si&&T.forceSinglePass===!1?(T.side=ti,T.needsUpdate=!0,Xi(T,z,Y),T.side=Ys,T.needsUpdate=!0,Xi(T,z,Y),T.side=si):Xi(T,z,Y)}this.compile=function(T,z,Q=null){Q===null&&(Q=T),F!==null&&F.renderStart(T,z,Q),E=it.get(Q),E.init(z),b.push(E),Q.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),T!==Q&&T.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),E.setupLights(),F!==null&&F.updateLights(E.state.lightsArray),un=this.localClippingEnabled,He=rt.init(this.clippingPlanes,un),He===!0&&rt.setGlobalState(this.clippingPlanes,z),F!==null&&gt.render(E.state.shadowsArray,Q,z);let Y=new Set;return T.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let At=Z.material;if(At)if(Array.isArray(At))for(let Dt=0;Dt<At.length;Dt++){let Ct=At[Dt];Fo(Ct,Q,z,Z),Y.add(Ct)}else Fo(At,Q,z,Z),Y.add(At)}),E=b.pop(),F!==null&&F.renderEnd(),Y},this.compileAsync=function(T,z,Q=null){let Y=this.compile(T,z,Q);return new Promise(Z=>{function At(){if(Y.forEach(function(Dt){let Nt=Ht.get(Dt).currentProgram;(Nt===void 0||Nt.isReady())&&Y.delete(Dt)}),Y.size===0){Z(T);return}setTimeout(At,10)}Qt.get("KHR_parallel_shader_compile")!==null?At():setTimeout(At,10)})};let Ar=null;function su(T){Ar&&Ar(T)}function Qa(){hs.stop()}function Wi(){hs.start()}let hs=new Eg;hs.setAnimationLoop(su),typeof self<"u"&&hs.setContext(self),this.setAnimationLoop=function(T){Ar=T,ht.setAnimationLoop(T),T===null?hs.stop():hs.start()},ht.addEventListener("sessionstart",Qa),ht.addEventListener("sessionend",Wi),this.render=function(T,z){if(z!==void 0&&z.isCamera!==!0){ie("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(A===!0)return;F!==null&&F.renderStart(T,z);let Q=ht.enabled===!0&&ht.isPresenting===!0,Y=O!==null&&(ct===null||Q)&&O.begin(D,ct);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),ht.enabled===!0&&ht.isPresenting===!0&&(O===null||O.isCompositing()===!1)&&(ht.cameraAutoUpdate===!0&&ht.updateCamera(z),z=ht.getCamera()),T.isScene===!0&&T.onBeforeRender(D,T,z,ct),E=it.get(T,b.length),E.init(z),E.state.textureUnits=Kt.getTextureUnits(),b.push(E),Be.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Je.setFromArrayCamera(z):oe.setFromProjectionMatrix(Be,bi,z.reversedDepth),un=this.localClippingEnabled,He=rt.init(this.clippingPlanes,un),P=St.get(T,_.length),P.init(),_.push(P),this.info.render.frame++,ht.enabled===!0&&ht.isPresenting===!0){let Dt=D.xr.getDepthSensingMesh();Dt!==null&&us(Dt,z,-1/0,D.sortObjects)}us(T,z,0,D.sortObjects),P.finish(),F!==null&&F.updateLights(E.state.lightsArray),D.sortObjects===!0&&P.sort($t,le),nn=ht.enabled===!1||ht.isPresenting===!1||ht.hasDepthSensing()===!1,nn&&B.addToRenderList(P,T),this.info.autoReset===!0&&this.info.reset(),He===!0&&rt.beginShadows();let Z=E.state.shadowsArray;if(gt.render(Z,T,z),He===!0&&rt.endShadows(),(Y&&O.hasRenderPass())===!1){let Dt=P.opaque,Ct=P.transmissive;if(E.setupLights(),z.isArrayCamera){let Nt=z.cameras;if(Ct.length>0)for(let Gt=0,se=Nt.length;Gt<se;Gt++){let ge=Nt[Gt];Ai(Dt,Ct,T,ge)}nn&&B.render(T);for(let Gt=0,se=Nt.length;Gt<se;Gt++){let ge=Nt[Gt];Oo(P,T,ge,ge.viewport)}}else Ct.length>0&&Ai(Dt,Ct,T,z),nn&&B.render(T),Oo(P,T,z)}ct!==null&&H===0&&(Kt.updateMultisampleRenderTarget(ct),Kt.updateRenderTargetMipmap(ct)),Y&&O.end(D),T.isScene===!0&&T.onAfterRender(D,T,z),bt.resetDefaultState(),K=-1,tt=null,b.pop(),b.length>0?(E=b[b.length-1],Kt.setTextureUnits(E.state.textureUnits),He===!0&&rt.setGlobalState(D.clippingPlanes,E.state.camera)):E=null,_.pop(),_.length>0?P=_[_.length-1]:P=null,F!==null&&F.renderEnd()};function us(T,z,Q,Y){if(T.visible===!1)return;if(T.layers.test(z.layers)){if(T.isGroup)Q=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(z);else if(T.isLight)E.pushLight(T),T.castShadow&&E.pushShadow(T);else if(T.isSprite){let Dt=z.isArrayCamera?Je:oe;if(!T.frustumCulled||T.intersectsFrustum(Dt)){Y&&be.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Be);let Ct=ut.update(T),Nt=T.material;Nt.visible&&P.push(T,Ct,Nt,Q,be.z,null,z)}}else if(T.isMesh||T.isLine||T.isPoints){let Dt=z.isArrayCamera?Je:oe;if(!T.frustumCulled||T.intersectsFrustum(Dt)){let Ct=ut.update(T),Nt=T.material;if(Y&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),be.copy(T.boundingSphere.center)):(Ct.boundingSphere===null&&Ct.computeBoundingSphere(),be.copy(Ct.boundingSphere.center)),be.applyMatrix4(T.matrixWorld).applyMatrix4(Be)),Array.isArray(Nt)){let Gt=Ct.groups;for(let se=0,ge=Gt.length;se<ge;se++){let Vt=Gt[se],_e=Nt[Vt.materialIndex];_e&&_e.visible&&P.push(T,Ct,_e,Q,be.z,Vt,z)}}else Nt.visible&&P.push(T,Ct,Nt,Q,be.z,null,z)}}}let At=T.children;for(let Dt=0,Ct=At.length;Dt<Ct;Dt++)us(At[Dt],z,Q,Y)}function Oo(T,z,Q,Y){let{opaque:Z,transmissive:At,transparent:Dt}=T;E.setupLightsView(Q),He===!0&&rt.setGlobalState(D.clippingPlanes,Q),Y&&Tt.viewport(nt.copy(Y)),Z.length>0&&sn(Z,z,Q),At.length>0&&sn(At,z,Q),Dt.length>0&&sn(Dt,z,Q),Tt.buffers.depth.setTest(!0),Tt.buffers.depth.setMask(!0),Tt.buffers.color.setMask(!0),Tt.setPolygonOffset(!1)}function Ai(T,z,Q,Y){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[Y.id]===void 0){let Vt=Qt.has("EXT_color_buffer_half_float")||Qt.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[Y.id]=new pi(1,1,{generateMipmaps:!0,type:Vt?Bi:ri,minFilter:ws,samples:Math.max(4,ce.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Se.workingColorSpace})}let At=E.state.transmissionRenderTarget[Y.id],Dt=Y.viewport||nt;At.setSize(Dt.z*D.transmissionResolutionScale,Dt.w*D.transmissionResolutionScale);let Ct=D.getRenderTarget(),Nt=D.getActiveCubeFace(),Gt=D.getActiveMipmapLevel();D.setRenderTarget(At),D.getClearColor(et),_t=D.getClearAlpha(),_t<1&&D.setClearColor(16777215,.5),D.clear(),nn&&B.render(Q);let se=D.toneMapping;D.toneMapping=os;let ge=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),E.setupLightsView(Y),He===!0&&rt.setGlobalState(D.clippingPlanes,Y),sn(T,Q,Y),Kt.updateMultisampleRenderTarget(At),Kt.updateRenderTargetMipmap(At),Qt.has("WEBGL_multisampled_render_to_texture")===!1){let Vt=!1;for(let _e=0,Qe=z.length;_e<Qe;_e++){let Ue=z[_e],{object:Fe,geometry:vn,material:Bt,group:dn}=Ue;if(Bt.side===si&&Fe.layers.test(Y.layers)){let ve=Bt.side;Bt.side=ti,Bt.needsUpdate=!0,cn(Fe,Q,Y,vn,Bt,dn),Bt.side=ve,Bt.needsUpdate=!0,Vt=!0}}Vt===!0&&(Kt.updateMultisampleRenderTarget(At),Kt.updateRenderTargetMipmap(At))}D.setRenderTarget(Ct,Nt,Gt),D.setClearColor(et,_t),ge!==void 0&&(Y.viewport=ge),D.toneMapping=se}function sn(T,z,Q){let Y=z.isScene===!0?z.overrideMaterial:null;for(let Z=0,At=T.length;Z<At;Z++){let Dt=T[Z],{object:Ct,geometry:Nt,group:Gt}=Dt,se=Dt.material;se.allowOverride===!0&&Y!==null&&(se=Y),Ct.layers.test(Q.layers)&&cn(Ct,z,Q,Nt,se,Gt)}}function cn(T,z,Q,Y,Z,At){F!==null&&Z.isNodeMaterial&&F.setObject(T,Z),T.onBeforeRender(D,z,Q,Y,Z,At),T.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),Z.onBeforeRender(D,z,Q,Y,T,At),Z.transparent===!0&&Z.side===si&&Z.forceSinglePass===!1?(Z.side=ti,Z.needsUpdate=!0,D.renderBufferDirect(Q,z,Y,Z,T,At),Z.side=Ys,Z.needsUpdate=!0,D.renderBufferDirect(Q,z,Y,Z,T,At),Z.side=si):D.renderBufferDirect(Q,z,Y,Z,T,At),T.onAfterRender(D,z,Q,Y,Z,At)}function hn(T){let z=0;for(let Q of T)Q.texture!==null&&z++;return z}function Xi(T,z,Q){z.isScene!==!0&&(z=yn);let Y=Ht.get(T),Z=E.state.lights,At=E.state.shadowsArray,Dt=Z.state.version,Ct=at.getParameters(T,Z.state,At,z,Q,E.state.lightProbeGridArray),Nt=at.getProgramCacheKey(Ct),Gt=Y.programs;Y.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?z.environment:null,Y.fog=z.fog;let se=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;Y.envMap=I.get(T.envMap||Y.environment,se),Y.envMapRotation=Y.environment!==null&&T.envMap===null?z.environmentRotation:T.envMapRotation,Gt===void 0&&(T.addEventListener("dispose",ue),Gt=new Map,Y.programs=Gt,Y.programVariants=new Map);let ge=Gt.get(Nt);if(ge!==void 0){if(Y.currentProgram===ge&&Y.lightsStateVersion===Dt)return Bo(T,Ct),ge}else Ct.uniforms=at.getUniforms(T),F!==null&&T.isNodeMaterial&&F.build(T,Q,Ct),T.onBeforeCompile(Ct,D),ge=at.acquireProgram(Ct,Nt),Gt.set(Nt,ge),Y.uniforms=Ct.uniforms;let Vt=Y.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(Vt.clippingPlanes=rt.uniform),Bo(T,Ct),Y.needsLights=Is(T),Y.lightsStateVersion=Dt,Y.needsLights&&(Vt.ambientLightColor.value=Z.state.ambient,Vt.lightProbe.value=Z.state.probe,Vt.sunLights.value=Z.state.sun,Vt.sunLightShadows.value=Z.state.sunShadow,Vt.directionalLights.value=Z.state.directional,Vt.directionalLightShadows.value=Z.state.directionalShadow,Vt.spotLights.value=Z.state.spot,Vt.spotLightShadows.value=Z.state.spotShadow,Vt.rectAreaLights.value=Z.state.rectArea,Vt.ltc_1.value=Z.state.rectAreaLTC1,Vt.ltc_2.value=Z.state.rectAreaLTC2,Vt.pointLights.value=Z.state.point,Vt.pointLightShadows.value=Z.state.pointShadow,Vt.hemisphereLights.value=Z.state.hemi,Vt.sunShadowMatrix.value=Z.state.sunShadowMatrix,Vt.sunShadowCascade.value=Z.state.sunShadowCascade,Vt.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Vt.spotLightMatrix.value=Z.state.spotLightMatrix,Vt.spotLightMap.value=Z.state.spotLightMap,Vt.pointShadowMatrix.value=Z.state.pointShadowMatrix),Y.numLightProbeGrids=hn(E.state.lightProbeGridArray),Y.currentProgram=ge,Y.uniformsList=null,ge}function ai(T,z,Q,Y,Z){let At=Ht.get(T),Dt=At.currentProgram.id+","+Y+","+Z,Ct=At.programVariants.get(Dt);return Ct===void 0?(Ct=Xi(T,z,Q),At.programVariants.set(Dt,Ct)):(At.currentProgram=Ct,At.uniformsList=null,At.outputColorSpace=Y,At.toneMapping=Z),Ct}function Ps(T){if(T.uniformsList===null){let z=T.currentProgram.getUniforms();T.uniformsList=bo.seqWithValue(z.seq,T.uniforms)}return T.uniformsList}function Bo(T,z){let Q=Ht.get(T);Q.outputColorSpace=z.outputColorSpace,Q.batching=z.batching,Q.batchingColor=z.batchingColor,Q.instancing=z.instancing,Q.instancingColor=z.instancingColor,Q.instancingMorph=z.instancingMorph,Q.skinning=z.skinning,Q.morphTargets=z.morphTargets,Q.morphNormals=z.morphNormals,Q.morphColors=z.morphColors,Q.morphTargetsCount=z.morphTargetsCount,Q.numClippingPlanes=z.numClippingPlanes,Q.numIntersection=z.numClipIntersection,Q.vertexAlphas=z.vertexAlphas,Q.vertexTangents=z.vertexTangents,Q.toneMapping=z.toneMapping}function ko(T,z,Q,Y,Z){z.isScene!==!0&&(z=yn),Kt.resetTextureUnits();let At=z.fog,Dt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?z.environment:null,Ct=ct===null?D.outputColorSpace:ct.isXRRenderTarget===!0?ct.texture.colorSpace:Se.workingColorSpace,Nt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Gt=I.get(Y.envMap||Dt,Nt),se=Y.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,ge=!!Q.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Vt=!!Q.morphAttributes.position,_e=!!Q.morphAttributes.normal,Qe=!!Q.morphAttributes.color,Ue=os;Y.toneMapped&&(ct===null||ct.isXRRenderTarget===!0)&&(Ue=D.toneMapping);let Fe=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,vn=Fe!==void 0?Fe.length:0,Bt=Ht.get(Y),dn=E.state.lights;if(He===!0&&(un===!0||T!==tt)){let Oe=T===tt&&Y.id===K;rt.setState(Y,T,Oe)}let ve=!1,fs=!1;Y.version===Bt.__version?Bt.needsLights&&Bt.lightsStateVersion!==dn.state.version||Z.isBatchedMesh&&Bt.batching===!1||!Z.isBatchedMesh&&Bt.batching===!0||Z.isBatchedMesh&&Bt.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Bt.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Bt.instancing===!1||!Z.isInstancedMesh&&Bt.instancing===!0||Z.isSkinnedMesh&&Bt.skinning===!1||!Z.isSkinnedMesh&&Bt.skinning===!0||Z.isInstancedMesh&&Bt.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Bt.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Bt.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Bt.instancingMorph===!1&&Z.morphTexture!==null||Bt.envMap!==Gt||Y.fog===!0&&Bt.fog!==At||Bt.numClippingPlanes!==void 0&&(Bt.numClippingPlanes!==rt.numPlanes||Bt.numIntersection!==rt.numIntersection)||Bt.vertexAlphas!==se||Bt.vertexTangents!==ge||Bt.morphTargets!==Vt||Bt.morphNormals!==_e||Bt.morphColors!==Qe||Bt.morphTargetsCount!==vn||Bt.numLightProbeGrids!==hn(E.state.lightProbeGridArray)?ve=!0:(Bt.outputColorSpace!==Ct||Bt.toneMapping!==Ue)&&(fs=!0):(ve=!0,Bt.__version=Y.version);let pn=Bt.currentProgram;(ve===!0||fs===!0)&&(pn=fs===!0?ai(Y,z,Z,Ct,Ue):Xi(Y,z,Z),F&&Y.isNodeMaterial&&F.onUpdateProgram(Y,pn,Bt));let Pr=!1,qi=!1,ds=!1,de=pn.getUniforms(),rn=Bt.uniforms;if(Tt.useProgram(pn.program)&&(Pr=!0,qi=!0,ds=!0),Y.id!==K&&(K=Y.id,qi=!0),Pr||tt!==T){Tt.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),de.setValue(k,"projectionMatrix",T.projectionMatrix),de.setValue(k,"viewMatrix",T.matrixWorldInverse);let mn=de.map.cameraPosition;mn!==void 0&&mn.setValue(k,Cn.setFromMatrixPosition(T.matrixWorld)),ce.logarithmicDepthBuffer&&de.setValue(k,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&de.setValue(k,"isOrthographic",T.isOrthographicCamera===!0),tt!==T&&(tt=T,qi=!0,ds=!0)}if(Bt.needsLights&&(dn.state.sunShadowMap.length>0&&de.setValue(k,"sunShadowMap",dn.state.sunShadowMap,Kt),dn.state.directionalShadowMap.length>0&&de.setValue(k,"directionalShadowMap",dn.state.directionalShadowMap,Kt),dn.state.spotShadowMap.length>0&&de.setValue(k,"spotShadowMap",dn.state.spotShadowMap,Kt),dn.state.pointShadowMap.length>0&&de.setValue(k,"pointShadowMap",dn.state.pointShadowMap,Kt)),Z.isSkinnedMesh){de.setOptional(k,Z,"bindMatrix"),de.setOptional(k,Z,"bindMatrixInverse");let Oe=Z.skeleton;Oe&&(Oe.boneTexture===null&&Oe.computeBoneTexture(),de.setValue(k,"boneTexture",Oe.boneTexture,Kt))}Z.isBatchedMesh&&(de.setOptional(k,Z,"batchingTexture"),de.setValue(k,"batchingTexture",Z._matricesTexture,Kt),de.setOptional(k,Z,"batchingIdTexture"),de.setValue(k,"batchingIdTexture",Z._indirectTexture,Kt),de.setOptional(k,Z,"batchingColorTexture"),Z._colorsTexture!==null&&de.setValue(k,"batchingColorTexture",Z._colorsTexture,Kt));let Wn=Q.morphAttributes;if((Wn.position!==void 0||Wn.normal!==void 0||Wn.color!==void 0)&&ot.update(Z,Q,pn),(qi||Bt.receiveShadow!==Z.receiveShadow)&&(Bt.receiveShadow=Z.receiveShadow,de.setValue(k,"receiveShadow",Z.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&z.environment!==null&&(rn.envMapIntensity.value=z.environmentIntensity),rn.dfgLUT!==void 0&&(rn.dfgLUT.value=rT()),qi){if(de.setValue(k,"toneMappingExposure",D.toneMappingExposure),Bt.needsLights&&Cr(rn,ds),At&&Y.fog===!0&&yt.refreshFogUniforms(rn,At),yt.refreshMaterialUniforms(rn,Y,wt,Pt,E.state.transmissionRenderTarget[T.id]),Bt.needsLights&&Bt.numLightProbeGrids>0){let Oe=S,mn=0;for(let kn of E.state.lightProbeGridArray)kn.texture!==null&&(Oe.textures[mn]=kn.texture,Oe.min[mn]=kn.boundingBox.min,Oe.max[mn]=kn.boundingBox.max,Oe.resolution[mn]=kn.resolution,mn++);for(let kn in Oe)Oe[kn].length=mn;rn.probesSH.value=Oe.textures,rn.probesMin.value=Oe.min,rn.probesMax.value=Oe.max,rn.probesResolution.value=Oe.resolution}bo.upload(k,Ps(Bt),rn,Kt)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(bo.upload(k,Ps(Bt),rn,Kt),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&de.setValue(k,"center",Z.center),de.setValue(k,"modelViewMatrix",Z.modelViewMatrix),de.setValue(k,"normalMatrix",Z.normalMatrix),de.setValue(k,"modelMatrix",Z.matrixWorld),Y.uniformsGroups!==void 0){let Oe=Y.uniformsGroups;for(let mn=0,kn=Oe.length;mn<kn;mn++){let tl=Oe[mn];qt.update(tl,pn),qt.bind(tl,pn)}}return pn}function Cr(T,z){T.ambientLightColor.needsUpdate=z,T.lightProbe.needsUpdate=z,T.sunLights.needsUpdate=z,T.sunLightShadows.needsUpdate=z,T.directionalLights.needsUpdate=z,T.directionalLightShadows.needsUpdate=z,T.pointLights.needsUpdate=z,T.pointLightShadows.needsUpdate=z,T.spotLights.needsUpdate=z,T.spotLightShadows.needsUpdate=z,T.rectAreaLights.needsUpdate=z,T.hemisphereLights.needsUpdate=z}function Is(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return ct},this.setRenderTargetTextures=function(T,z,Q){let Y=Ht.get(T);Y.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),Ht.get(T.texture).__webglTexture=z,Ht.get(T.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:Q,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,z){let Q=Ht.get(T);Q.__webglFramebuffer=z,Q.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(T,z=0,Q=0){ct=T,$=z,H=Q;let Y=null,Z=!1,At=!1;if(T){let Ct=Ht.get(T);if(Ct.__useDefaultFramebuffer!==void 0){Tt.bindFramebuffer(k.FRAMEBUFFER,Ct.__webglFramebuffer),nt.copy(T.viewport),pt.copy(T.scissor),ft=T.scissorTest,Tt.viewport(nt),Tt.scissor(pt),Tt.setScissorTest(ft),K=-1;return}else if(Ct.__webglFramebuffer===void 0)Kt.setupRenderTarget(T);else if(Ct.__hasExternalTextures)Kt.rebindTextures(T,Ht.get(T.texture).__webglTexture,Ht.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let se=T.depthTexture;if(Ct.__boundDepthTexture!==se){if(se!==null&&Ht.has(se)&&(T.width!==se.image.width||T.height!==se.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Kt.setupDepthRenderbuffer(T)}}let Nt=T.texture;(Nt.isData3DTexture||Nt.isDataArrayTexture||Nt.isCompressedArrayTexture)&&(At=!0);let Gt=Ht.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(Gt[z])?Y=Gt[z][Q]:Y=Gt[z],Z=!0):T.samples>0&&Kt.useMultisampledRTT(T)===!1?Y=Ht.get(T).__webglMultisampledFramebuffer:Array.isArray(Gt)?Y=Gt[Q]:Y=Gt,nt.copy(T.viewport),pt.copy(T.scissor),ft=T.scissorTest}else nt.copy(Xt).multiplyScalar(wt).floor(),pt.copy(me).multiplyScalar(wt).floor(),ft=fe;if(Q!==0&&(Y=G),Tt.bindFramebuffer(k.FRAMEBUFFER,Y)&&Tt.drawBuffers(T,Y),Tt.viewport(nt),Tt.scissor(pt),Tt.setScissorTest(ft),Z){let Ct=Ht.get(T.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+z,Ct.__webglTexture,Q)}else if(At){let Ct=z;for(let Nt=0;Nt<T.textures.length;Nt++){let Gt=Ht.get(T.textures[Nt]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Nt,Gt.__webglTexture,Q,Ct)}}else if(T!==null&&Q!==0){let Ct=Ht.get(T.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Ct.__webglTexture,Q)}K=-1};function Rr(T){let z=Ht.get(T);return(z.__readFormat!==T.format||z.__readType!==T.type)&&(z.__readFormat=T.format,z.__readType=T.type,z.__formatReadable=ce.textureFormatReadable(T.format),z.__typeReadable=ce.textureTypeReadable(T.type)),z}this.readRenderTargetPixels=function(T,z,Q,Y,Z,At,Dt,Ct=0){if(!(T&&T.isWebGLRenderTarget)){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Nt=Ht.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Dt!==void 0&&(Nt=Nt[Dt],Array.isArray(Nt)&&(Nt=Nt[0])),Nt){Tt.bindFramebuffer(k.FRAMEBUFFER,Nt);try{let Gt=T.textures[Ct],se=Gt.format,ge=Gt.type;T.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Ct);let Vt=Rr(Gt);if(Vt.__formatReadable===!1){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Vt.__typeReadable===!1){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=T.width-Y&&Q>=0&&Q<=T.height-Z&&k.readPixels(z,Q,Y,Z,xt.convert(se),xt.convert(ge),At)}finally{let Gt=ct!==null?Ht.get(ct).__webglFramebuffer:null;Tt.bindFramebuffer(k.FRAMEBUFFER,Gt)}}},this.readRenderTargetPixelsAsync=async function(T,z,Q,Y,Z,At,Dt,Ct=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Nt=Ht.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Dt!==void 0&&(Nt=Nt[Dt],Array.isArray(Nt)&&(Nt=Nt[0])),Nt)if(z>=0&&z<=T.width-Y&&Q>=0&&Q<=T.height-Z){Tt.bindFramebuffer(k.FRAMEBUFFER,Nt);let Gt=T.textures[Ct],se=Gt.format,ge=Gt.type;T.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Ct);let Vt=Rr(Gt);if(Vt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Vt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let _e=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,_e),k.bufferData(k.PIXEL_PACK_BUFFER,At.byteLength,k.STREAM_READ),k.readPixels(z,Q,Y,Z,xt.convert(se),xt.convert(ge),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let Qe=ct!==null?Ht.get(ct).__webglFramebuffer:null;Tt.bindFramebuffer(k.FRAMEBUFFER,Qe);let Ue=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await jm(k,Ue,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,_e),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,At),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(_e),k.deleteSync(Ue),At}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,z=null,Q=0){let Y=Math.pow(2,-Q),Z=Math.floor(T.image.width*Y),At=Math.floor(T.image.height*Y),Dt=z!==null?z.x:0,Ct=z!==null?z.y:0;Kt.setTexture2D(T,0),k.copyTexSubImage2D(k.TEXTURE_2D,Q,0,0,Dt,Ct,Z,At),Tt.unbindTexture()},this.copyTextureToTexture=function(T,z,Q=null,Y=null,Z=0,At=0){let Dt,Ct,Nt,Gt,se,ge,Vt,_e,Qe,Ue=T.isCompressedTexture?T.mipmaps[At]:T.image;if(Q!==null)Dt=Q.max.x-Q.min.x,Ct=Q.max.y-Q.min.y,Nt=Q.isBox3?Q.max.z-Q.min.z:1,Gt=Q.min.x,se=Q.min.y,ge=Q.isBox3?Q.min.z:0;else{let de=Math.pow(2,-Z);Dt=Math.floor(Ue.width*de),Ct=Math.floor(Ue.height*de),T.isDataArrayTexture?Nt=Ue.depth:T.isData3DTexture?Nt=Math.floor(Ue.depth*de):Nt=1,Gt=0,se=0,ge=0}Y!==null?(Vt=Y.x,_e=Y.y,Qe=Y.z):(Vt=0,_e=0,Qe=0);let Fe=xt.convert(z.format),vn=xt.convert(z.type),Bt;z.isData3DTexture?(Kt.setTexture3D(z,0),Bt=k.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(Kt.setTexture2DArray(z,0),Bt=k.TEXTURE_2D_ARRAY):(Kt.setTexture2D(z,0),Bt=k.TEXTURE_2D),Tt.activeTexture(k.TEXTURE0),Tt.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,z.flipY),Tt.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),Tt.pixelStorei(k.UNPACK_ALIGNMENT,z.unpackAlignment);let dn=Tt.getParameter(k.UNPACK_ROW_LENGTH),ve=Tt.getParameter(k.UNPACK_IMAGE_HEIGHT),fs=Tt.getParameter(k.UNPACK_SKIP_PIXELS),pn=Tt.getParameter(k.UNPACK_SKIP_ROWS),Pr=Tt.getParameter(k.UNPACK_SKIP_IMAGES);Tt.pixelStorei(k.UNPACK_ROW_LENGTH,Ue.width),Tt.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Ue.height),Tt.pixelStorei(k.UNPACK_SKIP_PIXELS,Gt),Tt.pixelStorei(k.UNPACK_SKIP_ROWS,se),Tt.pixelStorei(k.UNPACK_SKIP_IMAGES,ge);let qi=T.isDataArrayTexture||T.isData3DTexture,ds=z.isDataArrayTexture||z.isData3DTexture;if(T.isDepthTexture){let de=Ht.get(T),rn=Ht.get(z),Wn=Ht.get(de.__renderTarget),Oe=Ht.get(rn.__renderTarget);Tt.bindFramebuffer(k.READ_FRAMEBUFFER,Wn.__webglFramebuffer),Tt.bindFramebuffer(k.DRAW_FRAMEBUFFER,Oe.__webglFramebuffer);for(let mn=0;mn<Nt;mn++)qi&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Ht.get(T).__webglTexture,Z,ge+mn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Ht.get(z).__webglTexture,At,Qe+mn)),k.blitFramebuffer(Gt,se,Gt+Dt,se+Ct,Vt,_e,Vt+Dt,_e+Ct,k.DEPTH_BUFFER_BIT,k.NEAREST);Tt.bindFramebuffer(k.READ_FRAMEBUFFER,null),Tt.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(Z!==0||T.isRenderTargetTexture||Ht.has(T)){let de=Ht.get(T),rn=Ht.get(z);Tt.bindFramebuffer(k.READ_FRAMEBUFFER,N),Tt.bindFramebuffer(k.DRAW_FRAMEBUFFER,V);for(let Wn=0;Wn<Nt;Wn++)qi?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,de.__webglTexture,Z,ge+Wn):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,de.__webglTexture,Z),ds?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,rn.__webglTexture,At,Qe+Wn):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,rn.__webglTexture,At),Z!==0?k.blitFramebuffer(Gt,se,Gt+Dt,se+Ct,Vt,_e,Vt+Dt,_e+Ct,k.COLOR_BUFFER_BIT,k.NEAREST):ds?k.copyTexSubImage3D(Bt,At,Vt,_e,Qe+Wn,Gt,se,Dt,Ct):k.copyTexSubImage2D(Bt,At,Vt,_e,Gt,se,Dt,Ct);Tt.bindFramebuffer(k.READ_FRAMEBUFFER,null),Tt.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else ds?T.isDataTexture||T.isData3DTexture?k.texSubImage3D(Bt,At,Vt,_e,Qe,Dt,Ct,Nt,Fe,vn,Ue.data):z.isCompressedArrayTexture?k.compressedTexSubImage3D(Bt,At,Vt,_e,Qe,Dt,Ct,Nt,Fe,Ue.data):k.texSubImage3D(Bt,At,Vt,_e,Qe,Dt,Ct,Nt,Fe,vn,Ue):T.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,At,Vt,_e,Dt,Ct,Fe,vn,Ue.data):T.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,At,Vt,_e,Ue.width,Ue.height,Fe,Ue.data):k.texSubImage2D(k.TEXTURE_2D,At,Vt,_e,Dt,Ct,Fe,vn,Ue);Tt.pixelStorei(k.UNPACK_ROW_LENGTH,dn),Tt.pixelStorei(k.UNPACK_IMAGE_HEIGHT,ve),Tt.pixelStorei(k.UNPACK_SKIP_PIXELS,fs),Tt.pixelStorei(k.UNPACK_SKIP_ROWS,pn),Tt.pixelStorei(k.UNPACK_SKIP_IMAGES,Pr),At===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&k.generateMipmap(Bt),Tt.unbindTexture()},this.initRenderTarget=function(T){Ht.get(T).__webglFramebuffer===void 0&&Kt.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?Kt.setTextureCube(T,0):T.isData3DTexture?Kt.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?Kt.setTexture2DArray(T,0):Kt.setTexture2D(T,0),Tt.unbindTexture()},this.resetState=function(){$=0,H=0,ct=null,Tt.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return bi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Se._getDrawingBufferColorSpace(t),e.unpackColorSpace=Se._getUnpackColorSpace()}};var Og=110,oT=new rs({color:15311419,roughness:.55,metalness:.1}),Gf=new rs({color:4411740,roughness:.5,metalness:.35}),Bg=new rs({color:11122626,roughness:.4,metalness:.5}),aT=new X(0,1,0),lT=i=>[...i.points,i.grip,i.approach,i.closing].flat(),Ch=class{group=new On;grip=null;#t=null;#e=[];#n=[];#i=0;#s=80;goTo(t){let e=lT(t);this.#t??=this.#a(t.points.length),this.#e=this.#n.length===e.length?this.#r():e,this.#n=e,this.#i=performance.now()}open(t){return t===void 0||t===this.#s?!1:(this.#s=t,!0)}step(){return this.#t?(this.#c(this.#t,this.#r()),performance.now()-this.#i<Og):!1}#r(){let t=Math.min((performance.now()-this.#i)/Og,1);return this.#n.map((e,n)=>this.#e[n]+(e-this.#e[n])*t)}#o(t,e){let n=new Mn(t,e);return this.group.add(n),n}#a(t){let e=a=>58-30*(a/Math.max(t-1,1)),n=[];for(let a=0;a+1<t;++a)n.push(this.#o(new dr(e(a+1)*.8,e(a)*.8,1,24),oT));let s=[];for(let a=0;a<t;++a)s.push(this.#o(new pr(e(a),24,16),Gf));let r=()=>this.#o(new mi(9,24,52),Bg),o=this.#o(new dr(95,110,24,40),Gf);return o.rotation.x=Math.PI/2,{links:n,joints:s,foot:o,stem:this.#o(new dr(16,20,1,20),Bg),palm:this.#o(new mi(1,34,18),Gf),fingers:[r(),r()]}}#l(t,e,n){let s=n.clone().sub(e);t.visible=s.length()>1,t.position.copy(e).addScaledVector(s,.5),t.scale.set(1,Math.max(s.length(),1),1),t.quaternion.setFromUnitVectors(aT,s.normalize())}#c(t,e){let n=[];for(let y=0;y<e.length;y+=3)n.push(new X(e[y],e[y+1],e[y+2]));let[s,r,o]=n.splice(-3),{links:a,joints:l,foot:c,stem:h,palm:u,fingers:f}=t;c.position.copy(n[0]).setZ(12),a.forEach((y,p)=>this.#l(y,n[p],n[p+1])),l.forEach((y,p)=>y.position.copy(n[p])),this.grip=s;let d=new jn().setFromRotationMatrix(new De().makeBasis(o,new X().crossVectors(r,o),r)),m=s.clone().addScaledVector(r,-58);this.#l(h,n[n.length-1],m),u.position.copy(m),u.quaternion.copy(d),u.scale.setX(this.#s+26),f.forEach((y,p)=>{y.position.copy(s).addScaledVector(r,-26).addScaledVector(o,(p?1:-1)*(this.#s/2+5)),y.quaternion.copy(d)})}};var Hf=i=>i*Math.PI/180;function kg({at:i,pan:t,tilt:e,roll:n},s){let[r,o]=[Hf(t+s.pan),Hf(e+s.tilt)],a=new X(-Math.cos(r)*Math.cos(o),Math.sin(r)*Math.cos(o),Math.sin(o)),l=new X(Math.sin(r),Math.cos(r),0).applyAxisAngle(a,Hf(n));return{eye:new X(...i),right:l,down:new X().crossVectors(a,l),ahead:a}}var Wf=320;function cT({eye:i,right:t,down:e,ahead:n},s){let[,,r,o,a]=s,l=(u,f)=>i.clone().addScaledVector(n,Wf).addScaledVector(t,u*Wf*r/2/a).addScaledVector(e,f*Wf*o/2/a),c=[l(-1,-1),l(1,-1),l(1,1),l(-1,1)],h=c.flatMap((u,f)=>[i,u,u,c[(f+1)%4]]);return new is(new ln().setFromPoints(h),new wi({color:5223423,transparent:!0,opacity:.6}))}var hT={pan:0,tilt:0},Rh=class{#t;#e;#n=null;#i=null;#s=null;#r=null;#o=null;frame=null;constructor(t,e,n){this.#t=e,this.#e=n;let s=(r,o)=>t.follow(r,a=>{o(a.length?dt(a[0]):null),this.#a()});s("(camera-model ?eyes ?width ?height ?focal ?cx ?cy ?base)",r=>this.#s=r),s("(head ?pan ?tilt ?state)",r=>this.#r=r&&{pan:r[1],tilt:r[2]}),s("(camera-pose ?x ?y ?z ?pan ?tilt ?roll ?state ?spread ?guess)",r=>{this.#i=r&&{at:[r[1],r[2],r[3]],pan:r[4],tilt:r[5],roll:r[6]}})}setCell({camera:t}){this.#n=t,this.#a()}#a(){this.#o&&this.#t.scene.remove(this.#o);let t=this.#n&&{...this.#n,...this.#i},e=t?.head?this.#r:hT;this.frame=t&&e?kg(t,e):null,this.#o=this.frame&&this.#s&&this.#s[4]>0?cT(this.frame,this.#s):null,this.#o&&this.#t.scene.add(this.#o),this.#t.says("camera",!!this.#o),this.#e(),this.#t.ask()}};var zg={type:"change"},qf={type:"start"},Gg={type:"end"},Ph=new fr,Vg=new di,uT=Math.cos(70*Af.DEG2RAD),Tn=new X,oi=2*Math.PI,Pe={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Xf=1e-6,Ih=class extends Ia{constructor(t,e=null){super(t,e),this.state=Pe.NONE,this.target=new X,this.cursor=new X,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:qs.ROTATE,MIDDLE:qs.DOLLY,RIGHT:qs.PAN},this.touches={ONE:$s.ROTATE,TWO:$s.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new X,this._lastQuaternion=new jn,this._lastTargetPosition=new X,this._quat=new jn().setFromUnitVectors(t.up,new X(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new xo,this._sphericalDelta=new xo,this._scale=1,this._panOffset=new X,this._rotateStart=new Zt,this._rotateEnd=new Zt,this._rotateDelta=new Zt,this._panStart=new Zt,this._panEnd=new Zt,this._panDelta=new Zt,this._dollyStart=new Zt,this._dollyEnd=new Zt,this._dollyDelta=new Zt,this._dollyDirection=new X,this._mouse=new Zt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=dT.bind(this),this._onPointerDown=fT.bind(this),this._onPointerUp=pT.bind(this),this._onContextMenu=ST.bind(this),this._onMouseWheel=_T.bind(this),this._onKeyDown=xT.bind(this),this._onTouchStart=yT.bind(this),this._onTouchMove=vT.bind(this),this._onMouseDown=mT.bind(this),this._onMouseMove=gT.bind(this),this._interceptControlDown=MT.bind(this),this._interceptControlUp=bT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Pe.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(zg),this.update(),this.state=Pe.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Tn.copy(e).sub(this.target),Tn.applyQuaternion(this._quat),this._spherical.setFromVector3(Tn),this.autoRotate&&this.state===Pe.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=oi:n>Math.PI&&(n-=oi),s<-Math.PI?s+=oi:s>Math.PI&&(s-=oi),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Tn.setFromSpherical(this._spherical),Tn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Tn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Tn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new X(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new X(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Tn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Ph.origin.copy(this.object.position),Ph.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Ph.direction))<uT?this.object.lookAt(this.target):(Vg.setFromNormalAndCoplanarPoint(this.object.up,this.target),Ph.intersectPlane(Vg,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Xf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Xf||this._lastTargetPosition.distanceToSquared(this.target)>Xf?(this.dispatchEvent(zg),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?oi/60*this.autoRotateSpeed*t:oi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Tn.setFromMatrixColumn(e,0),Tn.multiplyScalar(-t),this._panOffset.add(Tn)}_panUp(t,e){this.screenSpacePanning===!0?Tn.setFromMatrixColumn(e,1):(Tn.setFromMatrixColumn(e,0),Tn.crossVectors(this.object.up,Tn)),Tn.multiplyScalar(t),this._panOffset.add(Tn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Tn.copy(s).sub(this.target);let r=Tn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(oi*this._rotateDelta.x/e.clientHeight),this._rotateUp(oi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(oi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-oi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(oi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-oi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(oi*this._rotateDelta.x/e.clientHeight),this._rotateUp(oi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Zt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function fT(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function dT(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function pT(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Gg),this.state=Pe.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function mT(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case qs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Pe.DOLLY;break;case qs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Pe.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Pe.ROTATE}break;case qs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Pe.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Pe.PAN}break;default:this.state=Pe.NONE}this.state!==Pe.NONE&&this.dispatchEvent(qf)}function gT(i){switch(this.state){case Pe.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Pe.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Pe.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function _T(i){this.enabled===!1||this.enableZoom===!1||this.state!==Pe.NONE||(i.preventDefault(),this.dispatchEvent(qf),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Gg))}function xT(i){this.enabled!==!1&&this._handleKeyDown(i)}function yT(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case $s.ROTATE:if(this.enableRotate===!1){this.state=Pe.NONE;break}this._handleTouchStartRotate(i),this.state=Pe.TOUCH_ROTATE;break;case $s.PAN:if(this.enablePan===!1){this.state=Pe.NONE;break}this._handleTouchStartPan(i),this.state=Pe.TOUCH_PAN;break;default:this.state=Pe.NONE}break;case 2:switch(this.touches.TWO){case $s.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Pe.TOUCH_DOLLY_PAN;break;case $s.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Pe.TOUCH_DOLLY_ROTATE;break;default:this.state=Pe.NONE}break;default:this.state=Pe.NONE}this.state!==Pe.NONE&&this.dispatchEvent(qf)}function vT(i){switch(this._trackPointer(i),this.state){case Pe.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Pe.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Pe.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Pe.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Pe.NONE}}function ST(i){this.enabled!==!1&&i.preventDefault()}function MT(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function bT(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var wT=80;function TT(i){let t=i.getContext(),e=t.getExtension("WEBGL_debug_renderer_info"),n=t.getParameter(e?e.UNMASKED_RENDERER_WEBGL:t.RENDERER);return/swiftshader|llvmpipe|software/i.test(n)}var $f=class{#t;constructor(t,e){this.canvas=e,this.box=e.parentElement,this.renderer=t,this.pause=TT(t)?wT:0,this.#t=ii(()=>this.draw()),this.moving=()=>!1,this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.scene=new ua,this.scene.background=new he(923422),this.camera=new Jn(36,1,10,8e3),this.camera.up.set(0,0,1),this.camera.position.set(1600,-1090,880),this.controls=new Ih(this.camera,e),this.controls.target.set(380,10,285),this.controls.maxDistance=4e3,this.controls.minDistance=200,this.controls.addEventListener("change",()=>this.ask()),this.controls.update(),this.light(),new ResizeObserver(()=>this.resize()).observe(this.box)}light(){let t=new Ca(16777215,2.2);t.position.set(900,-700,1600);let e=new Pa(2e3,20,3493983,1911863);e.rotation.x=Math.PI/2,this.scene.add(new Ta(14674674,2569277,1.3),new Ra(16777215,.25),t,e)}resize(){let{clientWidth:t,clientHeight:e}=this.box;!t||!e||(this.renderer.setSize(t,e,!1),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.ask())}ask(){this.#t()}says(t,e){this.canvas.dataset[t]=String(e)}draw(){let t=this.moving();this.renderer.render(this.scene,this.camera),t&&(this.pause?setTimeout(()=>this.ask(),this.pause):this.ask())}};function Hg(){let i=Rt("scene"),t;try{t=new Th({canvas:i,antialias:!0})}catch{return Rt("scene-note").hidden=!1,Rt("scene-note").textContent="This browser draws nothing in three dimensions (WebGL is off). All else works.",null}return new $f(t,i)}var ET=50,AT=2,Yf=ET*AT,Wg=.04,CT=new pr(1,20,14),RT=new ns({color:7127295,depthTest:!1,transparent:!0,opacity:.75});function PT([i,t,e,n,s,r]){let o=Math.sqrt(i),[a,l]=[t/o,e/o],c=Math.sqrt(n-a*a),h=(s-a*l)/c,u=Math.sqrt(r-l*l-h*h);return[o,c,u].every(f=>f>0)?[[o,a,l],[0,c,h],[0,0,u]]:null}function IT({spread:i,covariance:t},{eye:e,right:n,down:s,ahead:r},o){let a=t&&PT(t);if(a){let u=([f,d,m])=>new X().addScaledVector(n,f).addScaledVector(s,d).addScaledVector(r,m);return[u(a[0]),u(a[1]),u(a[2])]}if(i===void 0||!(i>0))return null;let l=new X().subVectors(o,e).normalize(),c=new X().crossVectors(l,s).normalize(),h=new X().crossVectors(l,c);return[l.multiplyScalar(i),c.multiplyScalar(Wg),h.multiplyScalar(Wg)]}var Lh=class{mesh=new Mn(CT,RT);constructor(){this.mesh.matrixAutoUpdate=!1,this.mesh.visible=!1}show(t,e,n){let s=t&&e&&n?IT(t,e,n):null;if(this.mesh.visible=s!==null,!s)return;let[r,o,a]=s;this.mesh.matrix=new De().makeBasis(r,o,a).scale(new X(Yf,Yf,Yf)),this.mesh.matrixWorldNeedsUpdate=!0}};var LT=160,Dh="end-effector",DT=.45,Zf={circle:i=>i.arc(64,64,34,0,2*Math.PI),square:i=>i.rect(33,33,62,62),triangle:i=>Xg(i,[[64,26],[102,96],[26,96]]),cross:i=>Xg(i,[[52,26],[76,26],[76,52],[102,52],[102,76],[76,76],[76,102],[52,102],[52,76],[26,76],[26,52],[52,52]])};function Xg(i,t){t.forEach(([e,n],s)=>s?i.lineTo(e,n):i.moveTo(e,n)),i.closePath()}function qg(i,t,e){let n=document.createElement("canvas");n.width=i,n.height=t,e(Ki(n));let s=new _a(n);return s.colorSpace=Zn,s}function NT(i){return qg(128,128,t=>{let[e,n]=i===Dh?["#14181b","#f4f6f7"]:["#f4f6f7","#14181b"];t.fillStyle=e,t.fillRect(0,0,128,128),t.fillStyle=n,t.beginPath();let s=i===Dh?Zf.triangle:Object.hasOwn(Zf,i)?Zf[i]:null;s&&s(t),t.fill(),!s&&(t.font="bold 64px system-ui, sans-serif",t.textAlign="center",t.fillText(i.slice(0,1).toUpperCase(),64,86))})}function UT(i){return qg(256,64,t=>{t.font="600 34px system-ui, sans-serif",t.textAlign="center",t.lineWidth=7,t.strokeStyle="#0e171e";let e=i.length>14?`${i.slice(0,13)}\u2026`:i;t.strokeText(e,128,44),t.fillStyle="#ffffff",t.fillText(e,128,44)})}var Nh=class{group=new On;#t;#e=null;#n=null;#i=0;#s;#r=new Lh;#o;constructor(t,e){this.#t=e;let n=new rs({color:15133420,roughness:.8}),s=NT(t);s.center.set(.5,.5),s.rotation=Math.PI/2;let r=new rs({map:s,roughness:.8}),o=t===Dh?4:e,a=t===Dh?e*.7:e,l=new Mn(new mi(o,a,a),[r,n,n,n,n,n]);l.position.setX(-o/2);let c=new ma(new po({map:UT(t),depthTest:!1}));c.scale.set(e*2.4,e*.6,1),c.position.set(-e/2,0,e*.85),this.#s=[n,r],this.#o=new Mn(new Ma(e*.85,e*.97,40),new ns({color:15901498,side:si,transparent:!0})),this.#o.position.set(-o/2,0,-a/2+2),this.#o.visible=!1,this.group.add(l,c,this.#r.mesh,this.#o)}believe(t,e){let n=t&&!["seen","found"].includes(t.state);for(let s of this.#s)s.opacity=n?DT:1,s.transparent=!!n;this.#r.show(t,e,this.#n)}hasSpread(){return this.#r.mesh.visible}mark(t){this.#o.visible=t}goTo(t,e,n){let s=new X(t,e,n);this.#e=this.#n?this.group.position.clone():s,this.#n=s,this.#i=performance.now()}step(){let t=Math.min((performance.now()-this.#i)/LT,1);return this.#e&&this.#n&&this.group.position.lerpVectors(this.#e,this.#n,t),t<1}top(){return this.group.position.clone().add(new X(-this.#t/2,0,this.#t/2))}};var FT=1.5,Uh=class{group=new On;constructor({parts:t}){let e=(l,c)=>{let h=2*Math.PI*l/t.length;return[c*Math.cos(h),c*Math.sin(h),FT]},n=[],s=[];t.forEach(([l,c],h)=>{let u=(h+1)%t.length,[f,d]=t[u];if(c===0||d===0)return;let[m,y,p,g]=[e(h,l),e(h,c),e(u,d),e(u,f)];n.push(...m,...y,...p,...m,...p,...g),s.push(...y,...p,...m,...g)});let r=new ln().setAttribute("position",new Re(n,3)),o=new ln().setAttribute("position",new Re(s,3)),a={color:8376715,transparent:!0,opacity:.07,side:si,depthWrite:!1};this.group.add(new Mn(r,new ns(a)),new is(o,new wi({color:5214043})))}standAt([t,e]){this.group.position.set(t,e,0)}};var OT=new wi({color:16732120,depthTest:!1,transparent:!0}),Fh=class{#t=new On;#e=new Map;#n=60;#i=R("span",{id:"truth-note",class:"quiet"});#s=R("input",{type:"checkbox",id:"truth"});#r=R("label",{class:"over",id:"truth-choice",hidden:!0},this.#s," The world\u2019s truth ",this.#i);constructor(t,e){this.view=e,e.scene.add(this.#t),Rt("scene-card").append(this.#r),this.#s.addEventListener("change",()=>{this.#a([]),this.#i.textContent="",t.layTruth(this.#s.checked?(n,s)=>this.#o(n,s):null)})}setCell({truth:t,cube:e}){this.#r.hidden=!t,this.#n=e}#o(t,e){if(!this.#s.checked)return;let n=(t??[]).filter(s=>J(s[0])==="cube"&&J(s[7])!=="gone");this.#i.textContent=t?`pink: ${n.length} objects, known to no agent`:e??"",this.#a(n)}#a(t){let e=new Set(t.map(n=>J(n[1])));for(let[n,s]of this.#e)e.has(n)||(this.#t.remove(s),this.#e.delete(n));for(let[,n,s,r,o,a]of t){let l=this.#e.get(J(n))??this.#l(J(n));l.position.set(s,r,o),l.rotation.z=a*Math.PI/180}this.view.says("truth",this.#e.size),this.view.ask()}#l(t){let e=new va(new mi(this.#n,this.#n,this.#n)),n=new is(e,OT);return n.renderOrder=1,this.#e.set(t,n),this.#t.add(n),n}};var BT=[0,1,2,6,7,11],kT=21;function $g(i){let t=o=>i.filter(Array.isArray).find(a=>J(a[0])===o)??[],[,e,n]=t("range"),s=t("pose")[7],r=Array.isArray(s)&&s.length===kT&&s.every(Number.isFinite);return{range:e,spread:n,covariance:r?BT.map(o=>s[o]):void 0}}function Yg(i,t,e){let n=i.get(t);(!n||(n.confidence??0)<(e.confidence??0))&&i.set(t,e)}function Zg(i,t){let e=new Map;for(let[,,,,s]of i.map(dt))for(let[r,o,...a]of s){let l=typeof a[0]=="number"?a[0]:void 0;Yg(e,J(r),{state:J(o),confidence:l,...$g(a)})}let n=new Set(e.keys());for(let[,,s,,r,,,,o]of t.map(dt))n.has(J(s))||Yg(e,J(s),{state:"found",confidence:r,...$g(o)});return e}var Jf=8;function zT(i){if(!i)return"not looked for";let{state:t,confidence:e,spread:n}=i;if(t!=="seen"&&t!=="found")return t;let s=e===void 0?t:`${(e*100).toFixed(0)} %`;return n&&n>0?`${s}  \xB1${(2*n).toFixed(1)} mm`:s}function Jg(i){let t=Rt("beliefs"),e=[],n=new Map,s=ii(()=>{let r=e.slice(0,Jf).flatMap(a=>[R("dt",{},Jt(a,16)),R("dd",{},zT(n.get(a)))]),o=e.length>Jf?[R("dt",{},"and"),R("dd",{},`${e.length-Jf} more`)]:[];t.replaceChildren(...r,...o)});return i.follow("(place ?name ?x ?y ?z ?frame)",r=>{e=r.map(o=>J(dt(o)[1])).sort(),s()}),r=>{n=r,s()}}var VT=i=>i.replace(/\d+\.\d+/g,t=>String(Math.round(Number(t)*10)/10)),Kf=i=>i.map(t=>t.toFixed(0)).join("  "),GT={pose:([,,...i])=>[["grip",`${Kf(i.slice(0,3))} mm`],["turned",`${Kf(i.slice(3))} \xB0`]],joints:([,,i])=>[["joints",Kf(i)]],gripper:([,,i])=>[["gripper",`${i.toFixed(0)} mm`]],arm:([,,i,t])=>[["arm",`${J(i)}  ${VT(J(t)).slice(0,40)}`]]},Oh=class{#t="robot";#e={};#n;constructor(t,e){this.#n=e;let n=(s,r)=>t.follow(r,o=>{this.#e[s]=o.map(dt),this.#s()});n("pose","(arm-pose ?robot ?x ?y ?z ?rx ?ry ?rz)"),n("joints","(arm-joints ?robot ?joints)"),n("gripper","(gripper ?robot ?opening)"),n("arm","(arm ?robot ?state ?action)")}show(t){this.#t=t,this.#s()}#i(t){return this.#e[t]?.find(e=>J(e[1])===this.#t)}#s(){let t=Object.entries(GT).flatMap(([e,n])=>{let s=this.#i(e);return s?n(s):[]});Rt("readings").replaceChildren(...t.flatMap(([e,n])=>[R("dt",{},e),R("dd",{},n)])),this.#n(this.#i("gripper")?.[2])}};var HT=64,WT={arms:[],reaches:{},cube:60},jf=class{line=new mo(new ln().setFromPoints([new X,new X]),new ba({color:15901498,dashSize:14,gapSize:9}));show(t,e){if(this.line.visible=!!(t&&e),!t||!e)return;let n=[t,e].flatMap(s=>[s.x,s.y,s.z]);this.line.geometry.setAttribute("position",new Re(n,3)),this.line.computeLineDistances()}};function XT(i,t){let e={servo:"",operation:"",pursued:!1},n=()=>t(e.pursued?e.servo||e.operation:"");i.follow("(servo ?state ?object ?x ?y ?d)",s=>{e.servo=s.length?J(dt(s[0])[2]):"",n()}),i.follow("(operation ?i ?operation ?state)",s=>{let[,,r,o]=s.length?dt(s[0]):[];e.operation=J(o)==="running"?J(r.at(-1)):"",n()}),i.follow("(goal-state ?n ?state ?detail)",s=>{e.pursued=s.some(r=>J(dt(r)[2])==="running"),n()})}function Kg(i,t){let e=Hg(),n=null,s=null,r="",o=WT,a="",l=new Map,c=new Map,h=new Oh(i,b=>e&&n?.open(b)&&e.ask()),u=Jg(i);if(!e)return t.onChange(()=>h.show(t.server("robot")||"robot")),{moveArm:()=>{},setCell:()=>{}};let f=new On,d=new jf,m=new Map,y=new Rh(i,e,()=>v()),p=new Fh(i,e);e.scene.add(f,d.line),e.moving=()=>{let b=n?.step()??!1,O=[...l.values()].map(D=>D.step());return d.show(n?.grip,l.get(r)?.top()),b||O.includes(!0)};let g=()=>{for(let[b,O]of l)O.mark(b===r);e.says("target",l.has(r)?r:""),e.ask()},v=()=>{for(let[b,O]of l)O.believe(m.get(b),y.frame);e.says("spread",[...l.values()].filter(b=>b.hasSpread()).length)},C=(b,[,,O,D,A])=>{let F=l.get(b);if(!F){if(l.size>=HT)return;F=new Nh(b,o.cube),l.set(b,F),f.add(F.group)}F.goTo(O,D,A)};i.follow("(place ?name ?x ?y ?z ?frame)",b=>{let O=new Map(b.map(D=>[J(dt(D)[1]),dt(D)]));for(let[D,A]of l)O.has(D)||(f.remove(A.group),l.delete(D));for(let[D,A]of O)C(D,A);v(),g()});let S={looks:[],found:[]},P=(b,O)=>i.follow(O,D=>{S[b]=D,m=Zg(S.looks,S.found),v(),u(m),e.ask()});P("looks","(look ?eyes ?frame ?text ?of)"),P("found","(found ?eyes ?name ?frame ?confidence ?second ?margin ?others ?places)"),XT(i,b=>{r=b,g()});let E=b=>{n||(n=new Ch,e.scene.add(n.group)),n.goTo(b),s?.standAt(b.points[0]),e.ask()},_=()=>{a=t.server("robot")||(o.arms[0]??"robot"),h.show(a);for(let O of[n,s])O&&e.scene.remove(O.group);n=null,s=o.reaches[a]?new Uh(o.reaches[a]):null,s&&e.scene.add(s.group),e.says("reach",!!s),e.says("arm",a);let b=c.get(a);b&&E(b),e.ask()};return t.onChange(()=>(t.server("robot")||a)!==a&&_()),{moveArm:b=>{c.set(b.arm,b),b.arm===a&&E(b)},setCell:b=>{o=b,y.setCell(b),p.setCell(b),_()}}}var qT="uplot",$T="u-hz",YT="u-vt",ZT="u-title",JT="u-wrap",KT="u-under",jT="u-over",QT="u-axis",Mr="u-off",tE="u-select",eE="u-cursor-x",nE="u-cursor-y",iE="u-cursor-pt",sE="u-legend",rE="u-live",oE="u-inline",aE="u-series",lE="u-marker",jg="u-label",cE="u-value",Xa="width",qa="height";var Qg="bottom",To="left",Qf="right",gd="#000",t0=gd+"0",td="mousemove",e0="mousedown",ed="mouseup",n0="mouseenter",i0="mouseleave",s0="dblclick",hE="resize",uE="scroll",r0="change",Gh="dppxchange",_d="--",Lo=typeof window<"u",od=Lo?document:null,Ao=Lo?window:null,fE=Lo?navigator:null,Ie,Bh;function ad(){let i=devicePixelRatio;Ie!=i&&(Ie=i,Bh&&cd(r0,Bh,ad),Bh=matchMedia(`(min-resolution: ${Ie-.001}dppx) and (max-resolution: ${Ie+.001}dppx)`),br(r0,Bh,ad),Ao.dispatchEvent(new CustomEvent(Gh)))}function _i(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function ld(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Ze(i,t,e){i.style[t]=e+"px"}function zi(i,t,e,n){let s=od.createElement(i);return t!=null&&_i(s,t),e?.insertBefore(s,n),s}function Ti(i,t){return zi("div",i,t)}var o0=new WeakMap;function cs(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=o0.get(i);r!=o&&(i.style.transform=r,o0.set(i,r),t<0||e<0||t>n||e>s?_i(i,Mr):ld(i,Mr))}var a0=new WeakMap;function l0(i,t,e){let n=t+e,s=a0.get(i);n!=s&&(a0.set(i,n),i.style.background=t,i.style.borderColor=e)}var c0=new WeakMap;function h0(i,t,e,n){let s=t+""+e,r=c0.get(i);s!=r&&(c0.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var xd={passive:!0},dE={...xd,capture:!0};function br(i,t,e,n){t.addEventListener(i,e,n?dE:xd)}function cd(i,t,e,n){t.removeEventListener(i,e,xd)}Lo&&ad();function Vi(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:xi((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function B0(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var k0=i=>i!=null,z0=i=>i!=null&&i>0,Xh=B0(k0),pE=B0(z0);function mE(i,t,e,n=0,s=!1){let r=s?pE:Xh,o=s?z0:k0;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Ve,l??-Ve]}function qh(i,t,e,n){let s=d0(i),r=d0(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?As:V0,a=s==1?xi:Ei,l=r==1?Ei:xi,c=a(o(An(i))),h=l(o(An(t))),u=Co(e,c),f=Co(e,h);return e==10&&(c<0&&(u=Ge(u,-c)),h<0&&(f=Ge(f,-h))),n||e==2?(i=u*s,t=f*r):(i=X0(i,u),t=$h(t,f)),[i,t]}function yd(i,t,e,n){let s=qh(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var vd=.1,u0={mode:3,pad:vd},Ya={pad:0,soft:null,mode:0},gE={min:Ya,max:Ya};function Hh(i,t,e,n){return Yh(e)?f0(i,t,e):(Ya.pad=e,Ya.soft=n?0:null,Ya.mode=n?3:0,f0(i,t,gE))}function Ae(i,t){return i??t}function _E(i,t,e){for(t=Ae(t,0),e=Ae(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function f0(i,t,e){let n=e.min,s=e.max,r=Ae(n.pad,0),o=Ae(s.pad,0),a=Ae(n.hard,-Ve),l=Ae(s.hard,Ve),c=Ae(n.soft,Ve),h=Ae(s.soft,-Ve),u=Ae(n.mode,0),f=Ae(s.mode,0),d=t-i,m=As(d),y=ei(An(i),An(t)),p=As(y),g=An(p-m);(d<1e-24||g>10)&&(d=0,(i==0||t==0)&&(d=1e-24,u==2&&c!=Ve&&(r=0),f==2&&h!=-Ve&&(o=0)));let v=d||y||1e3,C=As(v),S=Co(10,xi(C)),P=v*(d==0?i==0?.1:1:r),E=Ge(X0(i-P,S/10),24),_=i>=c&&(u==1||u==3&&E<=c||u==2&&E>=c)?c:Ve,b=ei(a,E<_&&i>=_?_:Gi(_,E)),O=v*(d==0?t==0?.1:1:o),D=Ge($h(t+O,S/10),24),A=t<=h&&(f==1||f==3&&D>=h||f==2&&D<=h)?h:-Ve,F=Gi(l,D>A&&t<=A?A:ei(A,D));return b==F&&b==0&&(F=100),[b,F]}var xE=new Intl.NumberFormat(Lo?fE.language:"en-US"),Sd=i=>xE.format(i),yi=Math,Vh=yi.PI,An=yi.abs,xi=yi.floor,En=yi.round,Ei=yi.ceil,Gi=yi.min,ei=yi.max,Co=yi.pow,d0=yi.sign,As=yi.log10,V0=yi.log2,yE=(i,t=1)=>yi.sinh(i)*t,nd=(i,t=1)=>yi.asinh(i/t),Ve=1/0;function p0(i){return(As((i^i>>31)-(i>>31))|0)+1}function hd(i,t,e){return Gi(ei(i,t),e)}function G0(i){return typeof i=="function"}function Me(i){return G0(i)?i:()=>i}var vE=()=>{},H0=i=>i,W0=(i,t)=>t,SE=i=>null,m0=i=>!0,g0=(i,t)=>i==t,ME=/\.\d*?(?=9{6,}|0{6,})/gm,wr=i=>{if($0(i)||js.has(i))return i;let t=`${i}`,e=t.match(ME);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${wr(s)}e${r}`}return Ge(i,n)};function vr(i,t){return wr(Ge(wr(i/t))*t)}function $h(i,t){return wr(Ei(wr(i/t))*t)}function X0(i,t){return wr(xi(wr(i/t))*t)}function Ge(i,t=0){if($0(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return En(n)/e}var js=new Map;function q0(i){return((""+i).split(".")[1]||"").length}function Ja(i,t,e,n){let s=[],r=n.map(q0);for(let o=t;o<e;o++){let a=An(o),l=Ge(Co(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?h:Ge(h,u);s.push(f),js.set(f,u)}}return s}var Za={},Md=[],Ro=[null,null],Ks=Array.isArray,$0=Number.isInteger,bE=i=>i===void 0;function _0(i){return typeof i=="string"}function Yh(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function wE(i){return i!=null&&typeof i=="object"}var TE=Object.getPrototypeOf(Uint8Array),Y0="__proto__";function Po(i,t=Yh){let e;if(Ks(i)){let n=i.find(s=>s!=null);if(Ks(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Po(i[s],t)}else e=i.slice()}else if(i instanceof TE)e=i.slice();else if(t(i)){e={};for(let n in i)n!=Y0&&(e[n]=Po(i[n],t))}else e=i;return e}function xn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=Y0&&(Yh(i[s])?xn(i[s],Po(n[s])):i[s]=Po(n[s]))}return i}var EE=0,AE=1,CE=2;function RE(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function PE(i,t){if(DE(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return NE(o[0])||(o=LE(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),f=t?t[o][c]:AE,d=[];for(let m=0;m<h.length;m++){let y=h[m],p=r.get(l[m]);y===null?f!=EE&&(u[p]=y,f==CE&&d.push(p)):u[p]=y}RE(u,d,s),n.push(u)}}return n}var IE=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function LE(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function DE(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function NE(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=ei(1,xi((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Z0=["January","February","March","April","May","June","July","August","September","October","November","December"],J0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function K0(i){return i.slice(0,3)}var UE=J0.map(K0),FE=Z0.map(K0),OE={MMMM:Z0,MMM:FE,WWWW:J0,WWW:UE};function Wa(i){return(i<10?"0":"")+i}function BE(i){return(i<10?"00":i<100?"0":"")+i}var kE={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Wa(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Wa(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Wa(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Wa(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Wa(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>BE(i.getMilliseconds())};function bd(i,t){t=t||OE;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?kE[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var zE=new Intl.DateTimeFormat().resolvedOptions().timeZone;function VE(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==zE?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var j0=i=>i%1==0,Wh=[1,2,2.5,5],GE=Ja(10,-32,0,Wh),Q0=Ja(10,0,32,Wh),HE=Q0.filter(j0),Sr=GE.concat(Q0),wd=`
`,t_="{YYYY}",x0=wd+t_,e_="{M}/{D}",$a=wd+e_,kh=$a+"/{YY}",n_="{aa}",WE="{h}:{mm}",Eo=WE+n_,y0=wd+Eo,v0=":{ss}",Ne=null;function i_(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?Ja(10,0,3,Wh).filter(j0):Ja(10,-3,0,Wh)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,t_,Ne,Ne,Ne,Ne,Ne,Ne,1],[s*28,"{MMM}",x0,Ne,Ne,Ne,Ne,Ne,1],[s,e_,x0,Ne,Ne,Ne,Ne,Ne,1],[n,"{h}"+n_,kh,Ne,$a,Ne,Ne,Ne,1],[e,Eo,kh,Ne,$a,Ne,Ne,Ne,1],[t,v0,kh+" "+Eo,Ne,$a+" "+Eo,Ne,y0,Ne,1],[i,v0+".{fff}",kh+" "+Eo,Ne,$a+" "+Eo,Ne,y0,Ne,1]];function h(u){return(f,d,m,y,p,g)=>{let v=[],C=p>=o,S=p>=r&&p<o,P=u(m),E=Ge(P*i,3),_=id(P.getFullYear(),C?0:P.getMonth(),S||C?1:P.getDate()),b=Ge(_*i,3);if(S||C){let O=S?p/r:0,D=C?p/o:0,A=E==b?E:Ge(id(_.getFullYear()+D,_.getMonth()+O,1)*i,3),F=new Date(En(A/i)),G=F.getFullYear(),N=F.getMonth();for(let V=0;A<=y;V++){let $=id(G+D*V,N+O*V,1),H=$-u(Ge($*i,3));A=Ge((+$+H)*i,3),A<=y&&v.push(A)}}else{let O=p>=s?s:p,D=xi(m)-xi(E),A=b+D+$h(E-b,O);v.push(A);let F=u(A),G=F.getHours()+F.getMinutes()/e+F.getSeconds()/n,N=p/n,V=f.axes[d]._space,$=g/V;for(;A=Ge(A+p,i==1?0:3),!(A>y);)if(N>1){let H=xi(Ge(G+N,6))%24,tt=u(A).getHours()-H;tt>1&&(tt=-1),A-=tt*n,G=(G+N)%24;let nt=v[v.length-1];Ge((A-nt)/p,3)*$>=.7&&v.push(A)}else v.push(A)}return v}}return[l,c,h]}var[XE,qE,$E]=i_(1),[YE,ZE,JE]=i_(.001);Ja(2,-53,53,[1]);function S0(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function M0(i,t){return(e,n,s,r,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],l,c,h,u,f,d;return n.map(m=>{let y=i(m),p=y.getFullYear(),g=y.getMonth(),v=y.getDate(),C=y.getHours(),S=y.getMinutes(),P=y.getSeconds(),E=p!=l&&a[2]||g!=c&&a[3]||v!=h&&a[4]||C!=u&&a[5]||S!=f&&a[6]||P!=d&&a[7]||a[1];return l=p,c=g,h=v,u=C,f=S,d=P,E(y)})}}function KE(i,t){let e=bd(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function id(i,t,e){return new Date(i,t,e)}function b0(i,t){return t(i)}var jE="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function w0(i,t){return(e,n,s,r)=>r==null?_d:t(i(n))}function QE(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function t1(i,t){return i.series[t].fill(i,t)}var e1={show:!0,live:!0,isolate:!1,mount:vE,markers:{show:!0,width:2,stroke:QE,fill:t1,dash:"solid"},idx:null,idxs:null,values:[]};function n1(i,t){let e=i.cursor.points,n=Ti(),s=e.size(i,t);Ze(n,Xa,s),Ze(n,qa,s);let r=s/-2;Ze(n,"marginLeft",r),Ze(n,"marginTop",r);let o=e.width(i,t,s);return o&&Ze(n,"borderWidth",o),n}function i1(i,t){let e=i.series[t].points;return e._fill||e._stroke}function s1(i,t){let e=i.series[t].points;return e._stroke||e._fill}function r1(i,t){return i.series[t].points.size}var sd=[0,0];function o1(i,t,e){return sd[0]=t,sd[1]=e,sd}function zh(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function rd(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var a1={show:!0,x:!0,y:!0,lock:!1,move:o1,points:{one:!1,show:n1,size:r1,width:0,stroke:s1,fill:i1},bind:{mousedown:zh,mouseup:zh,click:zh,dblclick:zh,mousemove:rd,mouseleave:rd,mouseenter:rd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},s_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Td=xn({},s_,{filter:W0}),r_=xn({},Td,{size:10}),o_=xn({},s_,{show:!1}),Ed='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',a_="bold "+Ed,l_=1.5,T0={show:!0,scale:"x",stroke:gd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:a_,side:2,grid:Td,ticks:r_,border:o_,font:Ed,lineGap:l_,rotate:0},l1="Value",c1="Time",E0={show:!0,scale:"x",auto:!1,sorted:1,min:Ve,max:-Ve,idxs:[]};function h1(i,t,e,n,s){return t.map(r=>r==null?"":Sd(r))}function u1(i,t,e,n,s,r,o){let a=[],l=js.get(s)||0;e=o?e:Ge($h(e,s),l);for(let c=e;c<=n;c=Ge(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function ud(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?As:V0,h=xi(c(e));s=Co(l,h),l==10&&(s=Sr[Vi(s,Sr)]);let u=e,f=s*l;l==10&&(f=Sr[Vi(f,Sr)]);do a.push(u),u=u+s,l==10&&!js.has(u)&&(u=Ge(u,js.get(s))),u>=f&&(s=u,f=s*l,l==10&&(f=Sr[Vi(f,Sr)]));while(u<=n);return a}function f1(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?ud(i,t,ei(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?ud(i,t,ei(l,-n),-e,s):[l]).reverse().map(f=>-f).concat(h,c)}var c_=/./,d1=/[12357]/,p1=/[125]/,A0=/1/,fd=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function m1(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?c_:l(7,o)-h>=c?d1:l(5,o)-h>=c?p1:A0;if(u==A0){let f=An(l(1,o)-h);if(f<c)return fd(t.slice().reverse(),a.distr,u,Ei(c/f)).reverse()}return fd(t,a.distr,u,1)}function g1(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=An(l(1,o)-l(2,o));return c<a?fd(t.slice().reverse(),3,c_,Ei(a/c)).reverse():t}function _1(i,t,e,n){return n==null?_d:t==null?"":Sd(t)}var C0={show:!0,scale:"y",stroke:gd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:a_,side:3,grid:Td,ticks:r_,border:o_,font:Ed,lineGap:l_,rotate:0};function x1(i,t){let e=3+(i||1)*2;return Ge(e*t,3)}function y1(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=An(o-r),l=i.series[t],c=a/(l.points.space*Ie);return n[1]-n[0]<=c}var R0={scale:null,auto:!0,sorted:0,min:Ve,max:-Ve},h_=(i,t,e,n,s)=>s,P0={show:!0,auto:!0,sorted:0,gaps:h_,alpha:1,facets:[xn({},R0,{scale:"x"}),xn({},R0,{scale:"y"})]},I0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:h_,alpha:1,points:{show:y1,filter:null},values:null,min:Ve,max:-Ve,idxs:[],path:null,clip:null};function v1(i,t,e,n,s){return e/10}var u_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},S1=xn({},u_,{time:!1,ori:1}),L0={};function f_(i,t){let e=L0[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(L0[i]=e)),e}var Io=1,dd=2;function Tr(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,m=a.width,y=a.height,p=i.valToPosH,g=i.valToPosV;return h.ori==0?e(s,l,c,h,u,p,g,f,d,m,y,Jh,Do,jh,p_,g_):e(s,l,c,h,u,g,p,d,f,y,m,Kh,No,Rd,m_,__)}function Ad(i,t){let e=0,n=0,s=Ae(i.bands,Md);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function M1(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Cs(i,t,e,n,s,r){return Tr(i,t,(o,a,l,c,h,u,f,d,m,y,p)=>{let g=o.pxRound,v=c.dir*(c.ori==0?1:-1),C=c.ori==0?Do:No,S,P;v==1?(S=e,P=n):(S=n,P=e);let E=g(u(a[S],c,y,d)),_=g(f(l[S],h,p,m)),b=g(u(a[P],c,y,d)),O=g(f(r==1?h.max:h.min,h,p,m)),D=new Path2D(s);return C(D,b,O),C(D,E,O),C(D,E,_),D})}function Zh(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?jh:Rd,l=e;for(let u=0;u<i.length;u++){let f=i[u];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+r),l=f[1]}}let c=e+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function b1(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Cd(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let u=c,f=c;if(s==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=r(i[u]),m=f==u?d:r(i[f]),y=u-s;d=o<=0&&y>=0&&y<l?r(i[y]):d;let g=f+s;m=o>=0&&g>=0&&g<l?r(i[g]):m,m>=d&&a.push([d,m])}return a}function D0(i){return i==0?H0:i==1?En:t=>vr(t,i)}function d_(i){let t=i==0?Jh:Kh,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Gi(c,a/2,l/2),h=Gi(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var Jh=(i,t,e)=>{i.moveTo(t,e)},Kh=(i,t,e)=>{i.moveTo(e,t)},Do=(i,t,e)=>{i.lineTo(t,e)},No=(i,t,e)=>{i.lineTo(e,t)},jh=d_(0),Rd=d_(1),p_=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},m_=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},g_=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},__=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function x_(i){return(t,e,n,s,r)=>Tr(t,e,(o,a,l,c,h,u,f,d,m,y,p)=>{let{pxRound:g,points:v}=o,C,S;c.ori==0?(C=Jh,S=p_):(C=Kh,S=m_);let P=Ge(v.width*Ie,3),E=(v.size-v.width)/2*Ie,_=Ge(E*2,3),b=new Path2D,O=new Path2D,{left:D,top:A,width:F,height:G}=t.bbox;jh(O,D-_,A-_,F+_*2,G+_*2);let N=V=>{if(l[V]!=null){let $=g(u(a[V],c,y,d)),H=g(f(l[V],h,p,m));C(b,$+E,H),S(b,$,H,E,0,Vh*2)}};if(r)r.forEach(N);else for(let V=n;V<=s;V++)N(V);return{stroke:P>0?b:null,fill:b,clip:O,flags:Io|dd}})}function y_(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var w1=y_(Do),T1=y_(No);function v_(i){let t=Ae(i?.alignGaps,0);return(e,n,s,r)=>Tr(e,n,(o,a,l,c,h,u,f,d,m,y,p)=>{[s,r]=Xh(l,s,r);let g=o.pxRound,v=G=>g(u(G,c,y,d)),C=G=>g(f(G,h,p,m)),S,P;c.ori==0?(S=Do,P=w1):(S=No,P=T1);let E=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Io},b=_.stroke,O=!1;if(r-s>=y*4){let G=ft=>e.posToVal(ft,c.key,!0),N=null,V=null,$,H,ct,K=v(a[E==1?s:r]),tt=v(a[s]),nt=v(a[r]),pt=G(E==1?tt+1:nt-1);for(let ft=E==1?s:r;ft>=s&&ft<=r;ft+=E){let et=a[ft],vt=(E==1?et<pt:et>pt)?K:v(et),Pt=l[ft];vt==K?Pt!=null?(H=Pt,N==null?(S(b,vt,C(H)),$=N=V=H):H<N?N=H:H>V&&(V=H)):Pt===null&&(O=!0):(N!=null&&P(b,K,C(N),C(V),C($),C(H)),Pt!=null?(H=Pt,S(b,vt,C(H)),N=V=$=H):(N=V=null,Pt===null&&(O=!0)),K=vt,pt=G(K+E))}N!=null&&N!=V&&ct!=K&&P(b,K,C(N),C(V),C($),C(H))}else for(let G=E==1?s:r;G>=s&&G<=r;G+=E){let N=l[G];N===null?O=!0:N!=null&&S(b,v(a[G]),C(N))}let[A,F]=Ad(e,n);if(o.fill!=null||A!=0){let G=_.fill=new Path2D(b),N=o.fillTo(e,n,o.min,o.max,A),V=C(N),$=v(a[s]),H=v(a[r]);E==-1&&([H,$]=[$,H]),S(G,H,V),S(G,$,V)}if(!o.spanGaps){let G=[];O&&G.push(...Cd(a,l,s,r,E,v,t)),_.gaps=G=o.gaps(e,n,s,r,G),_.clip=Zh(G,c.ori,d,m,y,p)}return F!=0&&(_.band=F==2?[Cs(e,n,s,r,b,-1),Cs(e,n,s,r,b,1)]:Cs(e,n,s,r,b,F)),_})}function E1(i){let t=Ae(i.align,1),e=Ae(i.ascDesc,!1),n=Ae(i.alignGaps,0),s=Ae(i.extend,!1);return(r,o,a,l)=>Tr(r,o,(c,h,u,f,d,m,y,p,g,v,C)=>{[a,l]=Xh(u,a,l);let S=c.pxRound,{left:P,width:E}=r.bbox,_=tt=>S(m(tt,f,v,p)),b=tt=>S(y(tt,d,C,g)),O=f.ori==0?Do:No,D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Io},A=D.stroke,F=f.dir*(f.ori==0?1:-1),G=b(u[F==1?a:l]),N=_(h[F==1?a:l]),V=N,$=N;s&&t==-1&&($=P,O(A,$,G)),O(A,N,G);for(let tt=F==1?a:l;tt>=a&&tt<=l;tt+=F){let nt=u[tt];if(nt==null)continue;let pt=_(h[tt]),ft=b(nt);t==1?O(A,pt,G):O(A,V,ft),O(A,pt,ft),G=ft,V=pt}let H=V;s&&t==1&&(H=P+E,O(A,H,G));let[ct,K]=Ad(r,o);if(c.fill!=null||ct!=0){let tt=D.fill=new Path2D(A),nt=c.fillTo(r,o,c.min,c.max,ct),pt=b(nt);O(tt,H,pt),O(tt,$,pt)}if(!c.spanGaps){let tt=[];tt.push(...Cd(h,u,a,l,F,_,n));let nt=c.width*Ie/2,pt=e||t==1?nt:-nt,ft=e||t==-1?-nt:nt;tt.forEach(et=>{et[0]+=pt,et[1]+=ft}),D.gaps=tt=c.gaps(r,o,a,l,tt),D.clip=Zh(tt,f.ori,p,g,v,C)}return K!=0&&(D.band=K==2?[Cs(r,o,a,l,A,-1),Cs(r,o,a,l,A,1)]:Cs(r,o,a,l,A,K)),D})}function N0(i,t,e,n,s,r,o=Ve){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=An(i[l]-i[a]);h<c&&(c=h,o=An(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function A1(i){i=i||Za;let t=Ae(i.size,[.6,Ve,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Me(s),o=1-t[0],a=Ae(t[1],Ve),l=Ae(t[2],1),c=Ae(i.disp,Za),h=Ae(i.each,d=>{}),{fill:u,stroke:f}=c;return(d,m,y,p)=>Tr(d,m,(g,v,C,S,P,E,_,b,O,D,A)=>{let F=g.pxRound,G=e,N=n*Ie,V=a*Ie,$=l*Ie,H,ct;S.ori==0?[H,ct]=r(d,m):[ct,H]=r(d,m);let K=S.dir*(S.ori==0?1:-1),tt=S.ori==0?jh:Rd,nt=S.ori==0?h:(Lt,Qt,ce,Tt,ze,Ht,Kt)=>{h(Lt,Qt,ce,ze,Tt,Kt,Ht)},pt=Ae(d.bands,Md).find(Lt=>Lt.series[0]==m),ft=pt!=null?pt.dir:0,et=g.fillTo(d,m,g.min,g.max,ft),_t=F(_(et,P,A,O)),vt,Pt,wt,$t=D,le=F(g.width*Ie),Xt=!1,me=null,fe=null,oe=null,Je=null;u!=null&&(le==0||f!=null)&&(Xt=!0,me=u.values(d,m,y,p),fe=new Map,new Set(me).forEach(Lt=>{Lt!=null&&fe.set(Lt,new Path2D)}),le>0&&(oe=f.values(d,m,y,p),Je=new Map,new Set(oe).forEach(Lt=>{Lt!=null&&Je.set(Lt,new Path2D)})));let{x0:He,size:un}=c;if(He!=null&&un!=null){G=1,v=He.values(d,m,y,p),He.unit==2&&(v=v.map(ce=>d.posToVal(b+ce*D,S.key,!0)));let Lt=un.values(d,m,y,p);un.unit==2?Pt=Lt[0]*D:Pt=E(Lt[0],S,D,b)-E(0,S,D,b),$t=N0(v,C,E,S,D,b,$t),wt=$t-Pt+N}else $t=N0(v,C,E,S,D,b,$t),wt=$t*o+N,Pt=$t-wt;wt<1&&(wt=0),le>=Pt/2&&(le=0),wt<5&&(F=H0);let Be=wt>0,Cn=$t-wt-(Be?le:0);Pt=F(hd(Cn,$,V)),vt=(G==0?Pt/2:G==K?0:Pt)-G*K*((G==0?N/2:0)+(Be?le/2:0));let be={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},yn=Xt?null:new Path2D,nn=null;if(pt!=null)nn=d.data[pt.series[1]];else{let{y0:Lt,y1:Qt}=c;Lt!=null&&Qt!=null&&(C=Qt.values(d,m,y,p),nn=Lt.values(d,m,y,p))}let fn=H*Pt,k=ct*Pt;for(let Lt=K==1?y:p;Lt>=y&&Lt<=p;Lt+=K){let Qt=C[Lt];if(Qt==null)continue;if(nn!=null){let q=nn[Lt]??0;if(Qt-q==0)continue;_t=_(q,P,A,O)}let ce=S.distr!=2||c!=null?v[Lt]:Lt,Tt=E(ce,S,D,b),ze=_(Ae(Qt,et),P,A,O),Ht=F(Tt-vt),Kt=F(ei(ze,_t)),I=F(Gi(ze,_t)),M=Kt-I;if(Qt!=null){let q=Qt<0?k:fn,ut=Qt<0?fn:k;Xt?(le>0&&oe[Lt]!=null&&tt(Je.get(oe[Lt]),Ht,I+xi(le/2),Pt,ei(0,M-le),q,ut),me[Lt]!=null&&tt(fe.get(me[Lt]),Ht,I+xi(le/2),Pt,ei(0,M-le),q,ut)):tt(yn,Ht,I+xi(le/2),Pt,ei(0,M-le),q,ut),nt(d,m,Lt,Ht-le/2,I,Pt+le,M)}}return le>0?be.stroke=Xt?Je:yn:Xt||(be._fill=g.width==0?g._fill:g._stroke??g._fill,be.width=0),be.fill=Xt?fe:yn,be})}function C1(i,t){let e=Ae(t?.alignGaps,0);return(n,s,r,o)=>Tr(n,s,(a,l,c,h,u,f,d,m,y,p,g)=>{[r,o]=Xh(c,r,o);let v=a.pxRound,C=H=>v(f(H,h,p,m)),S=H=>v(d(H,u,g,y)),P,E,_;h.ori==0?(P=Jh,_=Do,E=g_):(P=Kh,_=No,E=__);let b=h.dir*(h.ori==0?1:-1),O=C(l[b==1?r:o]),D=O,A=[],F=[];for(let H=b==1?r:o;H>=r&&H<=o;H+=b)if(c[H]!=null){let K=l[H],tt=C(K);A.push(D=tt),F.push(S(c[H]))}let G={stroke:i(A,F,P,_,E,v),fill:null,clip:null,band:null,gaps:null,flags:Io},N=G.stroke,[V,$]=Ad(n,s);if(a.fill!=null||V!=0){let H=G.fill=new Path2D(N),ct=a.fillTo(n,s,a.min,a.max,V),K=S(ct);_(H,D,K),_(H,O,K)}if(!a.spanGaps){let H=[];H.push(...Cd(l,c,r,o,b,C,e)),G.gaps=H=a.gaps(n,s,r,o,H),G.clip=Zh(H,h.ori,m,y,p,g)}return $!=0&&(G.band=$==2?[Cs(n,s,r,o,N,-1),Cs(n,s,r,o,N,1)]:Cs(n,s,r,o,N,$)),G})}function R1(i){return C1(P1,i)}function P1(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let f=0;f<o-1;f++)h[f]=t[f+1]-t[f],u[f]=i[f+1]-i[f],c[f]=h[f]/u[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/c[f-1]+(u[f]+2*u[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+u[f]/3,t[f]+l[f]*u[f]/3,i[f+1]-u[f]/3,t[f+1]-l[f+1]*u[f]/3,i[f+1],t[f+1])}return a}var pd=new Set;function U0(){for(let i of pd)i.syncRect(!0)}Lo&&(br(hE,Ao,U0),br(uE,Ao,U0,!0),br(Gh,Ao,()=>{Bn.pxRatio=Ie}));var I1=v_(),L1=x_();function F0(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>md(r,o,t,e))}function D1(i,t){return i.map((e,n)=>n==0?{}:xn({},t,e))}function md(i,t,e,n){return xn({},t==0?e:n,i)}function S_(i,t,e){return t==null?Ro:[t,e]}var N1=S_;function U1(i,t,e){return t==null?Ro:Hh(t,e,vd,!0)}function M_(i,t,e,n){return t==null?Ro:qh(t,e,i.scales[n].log,!1)}var F1=M_;function b_(i,t,e,n){return t==null?Ro:yd(t,e,i.scales[n].log,!1)}var O1=b_;function B1(i,t,e,n,s){let r=ei(p0(i),p0(t)),o=t-i,a=Vi(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?js.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function O0(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=En((e=+s)*Ie))+"px"),[i,t,e]}function k1(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Ge(t[2]*Ie,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Bn(i,t,e){let n={mode:Ae(i.mode,1)},s=n.mode;function r(x,w,L,U){let W=w.valToPct(x);return U+L*(w.dir==-1?1-W:W)}function o(x,w,L,U){let W=w.valToPct(x);return U+L*(w.dir==-1?W:1-W)}function a(x,w,L,U){return w.ori==0?r(x,w,L,U):o(x,w,L,U)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=Ti(qT);if(i.id!=null&&(c.id=i.id),_i(c,i.class),i.title){let x=Ti(ZT,c);x.textContent=i.title}let h=zi("canvas"),u=n.ctx=h.getContext("2d"),f=Ti(JT,c);br("click",f,x=>{x.target===m&&(Xe!=Dr||Ke!=Nr)&&Fn.click(n,x)},!0);let d=n.under=Ti(KT,f);f.appendChild(h);let m=n.over=Ti(jT,f);i=Po(i);let y=+Ae(i.pxAlign,1),p=D0(y);(i.plugins||[]).forEach(x=>{x.opts&&(i=x.opts(n,i)||i)});let g=i.ms||.001,v=n.series=s==1?F0(i.series||[],E0,I0,!1):D1(i.series||[null],P0),C=n.axes=F0(i.axes||[],T0,C0,!0),S=n.scales={},P=n.bands=i.bands||[];P.forEach(x=>{x.fill=Me(x.fill||null),x.dir=Ae(x.dir,-1)});let E=s==2?v[1].facets[0].scale:v[0].scale,_={axes:ds,series:_e},b=(i.drawOrder||["axes","series"]).map(x=>_[x]);function O(x){let w=x.distr==3?L=>As(L>0?L:x.clamp(n,L,x.min,x.max,x.key)):x.distr==4?L=>nd(L,x.asinh):x.distr==100?L=>x.fwd(L):L=>L;return L=>{let U=w(L),{_min:W,_max:j}=x,lt=j-W;return(U-W)/lt}}function D(x){let w=S[x];if(w==null){let L=(i.scales||Za)[x]||Za;if(L.from!=null){D(L.from);let U=xn({},S[L.from],L,{key:x});U.valToPct=O(U),S[x]=U}else{w=S[x]=xn({},x==E?u_:S1,L),w.key=x;let U=w.time,W=w.range,j=Ks(W);if((x!=E||s==2&&!U)&&(j&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?u0:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?u0:{mode:1,hard:W[1],soft:W[1]}},j=!1),!j&&Yh(W))){let lt=W;W=(mt,Mt,Ft)=>Mt==null?Ro:Hh(Mt,Ft,lt)}w.range=Me(W||(U?N1:x==E?w.distr==3?F1:w.distr==4?O1:S_:w.distr==3?M_:w.distr==4?b_:U1)),w.auto=Me(j?!1:w.auto),w.clamp=Me(w.clamp||v1),w._min=w._max=null,w.valToPct=O(w)}}}D("x"),D("y"),s==1&&v.forEach(x=>{D(x.scale)}),C.forEach(x=>{D(x.scale)});for(let x in i.scales)D(x);let A=S[E],F=A.distr,G,N;A.ori==0?(_i(c,$T),G=r,N=o):(_i(c,YT),G=o,N=r);let V={};for(let x in S){let w=S[x];(w.min!=null||w.max!=null)&&(V[x]={min:w.min,max:w.max},w.min=w.max=null)}let $=i.tzDate||(x=>new Date(En(x/g))),H=i.fmtDate||bd,ct=g==1?$E($):JE($),K=M0($,S0(g==1?qE:ZE,H)),tt=w0($,b0(jE,H)),nt=[],pt=n.legend=xn({},e1,i.legend),ft=n.cursor=xn({},a1,{drag:{y:s==2}},i.cursor),et=pt.show,_t=ft.show,vt=pt.markers;pt.idxs=nt,vt.width=Me(vt.width),vt.dash=Me(vt.dash),vt.stroke=Me(vt.stroke),vt.fill=Me(vt.fill);let Pt,wt,$t,le=[],Xt=[],me,fe=!1,oe={};if(pt.live){let x=v[1]?v[1].values:null;fe=x!=null,me=fe?x(n,1,0):{_:0};for(let w in me)oe[w]=_d}if(et)if(Pt=zi("table",sE,c),$t=zi("tbody",null,Pt),pt.mount(n,Pt),fe){wt=zi("thead",null,Pt,$t);let x=zi("tr",null,wt);zi("th",null,x);for(var Je in me)zi("th",jg,x).textContent=Je}else _i(Pt,oE),pt.live&&_i(Pt,rE);let He={show:!0},un={show:!1};function Be(x,w){if(w==0&&(fe||!pt.live||s==2))return Ro;let L=[],U=zi("tr",aE,$t,$t.childNodes[w]);_i(U,x.class),x.show||_i(U,Mr);let W=zi("th",null,U);if(vt.show){let mt=Ti(lE,W);if(w>0){let Mt=vt.width(n,w);Mt&&(mt.style.border=Mt+"px "+vt.dash(n,w)+" "+vt.stroke(n,w)),mt.style.background=vt.fill(n,w)}}let j=Ti(jg,W);x.label instanceof HTMLElement?j.appendChild(x.label):j.textContent=x.label,w>0&&(vt.show||(j.style.color=x.width>0?vt.stroke(n,w):vt.fill(n,w)),be("click",W,mt=>{if(ft._lock)return;ee(mt);let Mt=v.indexOf(x);if((mt.ctrlKey||mt.metaKey)!=pt.isolate){let Ft=v.some((Ot,kt)=>kt>0&&kt!=Mt&&Ot.show);v.forEach((Ot,kt)=>{kt>0&&$i(kt,Ft?kt==Mt?He:un:He,!0,gn.setSeries)})}else $i(Mt,{show:!x.show},!0,gn.setSeries)},!1),ne&&be(n0,W,mt=>{ft._lock||(ee(mt),$i(v.indexOf(x),Fr,!0,gn.setSeries))},!1));for(var lt in me){let mt=zi("td",cE,U);mt.textContent="--",L.push(mt)}return[U,L]}let Cn=new Map;function be(x,w,L,U=!0){let W=Cn.get(w)||{},j=ft.bind[x](n,w,L,U);j&&(br(x,w,W[x]=j),Cn.set(w,W))}function yn(x,w,L){let U=Cn.get(w)||{};for(let W in U)(x==null||W==x)&&(cd(W,w,U[W]),delete U[W]);x==null&&Cn.delete(w)}let nn=0,fn=0,k=0,Lt=0,Qt=0,ce=0,Tt=Qt,ze=ce,Ht=k,Kt=Lt,I=0,M=0,q=0,ut=0;n.bbox={};let at=!1,yt=!1,St=!1,it=!1,rt=!1,gt=!1;function B(x,w,L){(L||x!=n.width||w!=n.height)&&ot(x,w),de(!1),St=!0,yt=!0,kn()}function ot(x,w){n.width=nn=k=x,n.height=fn=Lt=w,Qt=ce=0,bt(),qt();let L=n.bbox;I=L.left=vr(Qt*Ie,.5),M=L.top=vr(ce*Ie,.5),q=L.width=vr(k*Ie,.5),ut=L.height=vr(Lt*Ie,.5)}let st=3;function Et(){let x=!1,w=0;for(;!x;){w++;let L=Pr(w),U=qi(w);x=w==st||L&&U,x||(ot(n.width,n.height),yt=!0)}}function xt({width:x,height:w}){B(x,w)}n.setSize=xt;function bt(){let x=!1,w=!1,L=!1,U=!1;C.forEach((W,j)=>{if(W.show&&W._show){let{side:lt,_size:mt}=W,Mt=lt%2,Ft=W.label!=null?W.labelSize:0,Ot=mt+Ft;Ot>0&&(Mt?(k-=Ot,lt==3?(Qt+=Ot,U=!0):L=!0):(Lt-=Ot,lt==0?(ce+=Ot,x=!0):w=!0))}}),Wi[0]=x,Wi[1]=L,Wi[2]=w,Wi[3]=U,k-=Ai[1]+Ai[3],Qt+=Ai[3],Lt-=Ai[2]+Ai[0],ce+=Ai[0]}function qt(){let x=Qt+k,w=ce+Lt,L=Qt,U=ce;function W(j,lt){switch(j){case 1:return x+=lt,x-lt;case 2:return w+=lt,w-lt;case 3:return L-=lt,L+lt;case 0:return U-=lt,U+lt}}C.forEach((j,lt)=>{if(j.show&&j._show){let mt=j.side;j._pos=W(mt,j._size),j.label!=null&&(j._lpos=W(mt,j.labelSize))}})}if(ft.dataIdx==null){let x=ft.hover,w=x.skip=new Set(x.skip??[]);w.add(void 0);let L=x.prox=Me(x.prox),U=x.bias??=0;ft.dataIdx=(W,j,lt,mt)=>{if(j==0)return lt;let Mt=lt,Ft=L(W,j,lt,mt)??Ve,Ot=Ft>=0&&Ft<Ve,kt=A.ori==0?k:Lt,ae=ft.left,Ce=t[0],Ee=t[j];if(w.has(Ee[lt])){Mt=null;let ye=null,te=null,Yt;if(U==0||U==-1)for(Yt=lt;ye==null&&Yt-- >0;)w.has(Ee[Yt])||(ye=Yt);if(U==0||U==1)for(Yt=lt;te==null&&Yt++<Ee.length;)w.has(Ee[Yt])||(te=Yt);if(ye!=null||te!=null)if(Ot){let $e=ye==null?-1/0:G(Ce[ye],A,kt,0),on=te==null?1/0:G(Ce[te],A,kt,0),Ln=ae-$e,ke=on-ae;Ln<=ke?Ln<=Ft&&(Mt=ye):ke<=Ft&&(Mt=te)}else Mt=te==null?ye:ye==null?te:lt-ye<=te-lt?ye:te}else Ot&&An(ae-G(Ce[lt],A,kt,0))>Ft&&(Mt=null);return Mt}}let ee=x=>{ft.event=x};ft.idxs=nt,ft._lock=!1;let ht=ft.points;ht.show=Me(ht.show),ht.size=Me(ht.size),ht.stroke=Me(ht.stroke),ht.width=Me(ht.width),ht.fill=Me(ht.fill);let zt=n.focus=xn({},i.focus||{alpha:.3},ft.focus),ne=zt.prox>=0,It=ne&&ht.one,ue=[],We=[],Hn=[];function Fo(x,w){let L=ht.show(n,w);if(L instanceof HTMLElement)return _i(L,iE),_i(L,x.class),cs(L,-10,-10,k,Lt),m.insertBefore(L,ue[w]),L}function Ar(x,w){if(s==1||w>0){let L=s==1&&S[x.scale].time,U=x.value;x.value=L?_0(U)?w0($,b0(U,H)):U||tt:U||_1,x.label=x.label||(L?c1:l1)}if(It||w>0){x.width=x.width==null?1:x.width,x.paths=x.paths||I1||SE,x.fillTo=Me(x.fillTo||M1),x.pxAlign=+Ae(x.pxAlign,y),x.pxRound=D0(x.pxAlign),x.stroke=Me(x.stroke||null),x.fill=Me(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let L=x1(ei(1,x.width),1),U=x.points=xn({},{size:L,width:ei(1,L*.2),stroke:x.stroke,space:L*2,paths:L1,_stroke:null,_fill:null},x.points);U.show=Me(U.show),U.filter=Me(U.filter),U.fill=Me(U.fill),U.stroke=Me(U.stroke),U.paths=Me(U.paths),U.pxAlign=x.pxAlign}if(et){let L=Be(x,w);le.splice(w,0,L[0]),Xt.splice(w,0,L[1]),pt.values.push(null)}if(_t){nt.splice(w,0,null);let L=null;It?w==0&&(L=Fo(x,w)):w>0&&(L=Fo(x,w)),ue.splice(w,0,L),We.splice(w,0,0),Hn.splice(w,0,0)}In("addSeries",w)}function su(x,w){w=w??v.length,x=s==1?md(x,w,E0,I0):md(x,w,{},P0),v.splice(w,0,x),Ar(v[w],w)}n.addSeries=su;function Qa(x){if(v.splice(x,1),et){pt.values.splice(x,1),Xt.splice(x,1);let w=le.splice(x,1)[0];yn(null,w.firstChild),w.remove()}_t&&(nt.splice(x,1),ue.splice(x,1)[0].remove(),We.splice(x,1),Hn.splice(x,1)),In("delSeries",x)}n.delSeries=Qa;let Wi=[!1,!1,!1,!1];function hs(x,w){if(x._show=x.show,x.show){let L=x.side%2,U=S[x.scale];U==null&&(x.scale=L?v[1].scale:E,U=S[x.scale]);let W=U.time;x.size=Me(x.size),x.space=Me(x.space),x.rotate=Me(x.rotate),Ks(x.incrs)&&x.incrs.forEach(lt=>{!js.has(lt)&&js.set(lt,q0(lt))}),x.incrs=Me(x.incrs||(U.distr==2?HE:W?g==1?XE:YE:Sr)),x.splits=Me(x.splits||(W&&U.distr==1?ct:U.distr==3?ud:U.distr==4?f1:u1)),x.stroke=Me(x.stroke),x.grid.stroke=Me(x.grid.stroke),x.ticks.stroke=Me(x.ticks.stroke),x.border.stroke=Me(x.border.stroke);let j=x.values;x.values=Ks(j)&&!Ks(j[0])?Me(j):W?Ks(j)?M0($,S0(j,H)):_0(j)?KE($,j):j||K:j||h1,x.filter=Me(x.filter||(U.distr>=3&&U.log==10?m1:U.distr==3&&U.log==2?g1:W0)),x.font=O0(x.font),x.labelFont=O0(x.labelFont),x._size=x.size(n,null,w,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(Wi[w]=!0,x._el=Ti(QT,f))}}function us(x,w,L,U){let[W,j,lt,mt]=L,Mt=w%2,Ft=0;return Mt==0&&(mt||j)&&(Ft=w==0&&!W||w==2&&!lt?En(T0.size/3):0),Mt==1&&(W||lt)&&(Ft=w==1&&!j||w==3&&!mt?En(C0.size/2):0),Ft}let Oo=n.padding=(i.padding||[us,us,us,us]).map(x=>Me(Ae(x,us))),Ai=n._padding=Oo.map((x,w)=>x(n,w,Wi,0)),sn,cn=null,hn=null,Xi=s==1?v[0].idxs:null,ai=null,Ps=!1;function Bo(x,w){if(t=x??[],n.data=n._data=t,s==2){sn=0;for(let L=1;L<v.length;L++)sn+=t[L][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),ai=t[0],sn=ai.length;let L=t;if(F==2){L=t.slice();let U=L[0]=Array(sn);for(let W=0;W<sn;W++)U[W]=W}n._data=t=L}if(de(!0),In("setData"),F==2&&(St=!0),w!==!1){let L=A;L.auto(n,Ps)?ko():Ds(E,L.min,L.max),it=it||ft.left>=0,gt=!0,kn()}}n.setData=Bo;function ko(){Ps=!0;let x,w;s==1&&(sn>0?(cn=Xi[0]=0,hn=Xi[1]=sn-1,x=t[0][cn],w=t[0][hn],F==2?(x=cn,w=hn):x==w&&(F==3?[x,w]=qh(x,x,A.log,!1):F==4?[x,w]=yd(x,x,A.log,!1):A.time?w=x+En(86400/g):[x,w]=Hh(x,w,vd,!0))):(cn=Xi[0]=x=null,hn=Xi[1]=w=null)),Ds(E,x,w)}let Cr,Is,Rr,T,z,Q,Y,Z,At,Dt;function Ct(x,w,L,U,W,j){x??=t0,L??=Md,U??="butt",W??=t0,j??="round",x!=Cr&&(u.strokeStyle=Cr=x),W!=Is&&(u.fillStyle=Is=W),w!=Rr&&(u.lineWidth=Rr=w),j!=z&&(u.lineJoin=z=j),U!=Q&&(u.lineCap=Q=U),L!=T&&u.setLineDash(T=L)}function Nt(x,w,L,U){w!=Is&&(u.fillStyle=Is=w),x!=Y&&(u.font=Y=x),L!=Z&&(u.textAlign=Z=L),U!=At&&(u.textBaseline=At=U)}function Gt(x,w,L,U,W=0){if(U.length>0&&x.auto(n,Ps)&&(w==null||w.min==null)){let j=Ae(cn,0),lt=Ae(hn,U.length-1),mt=L.min==null?mE(U,j,lt,W,x.distr==3):[L.min,L.max];x.min=Gi(x.min,L.min=mt[0]),x.max=ei(x.max,L.max=mt[1])}}let se={min:null,max:null};function ge(){for(let U in S){let W=S[U];V[U]==null&&(W.min==null||V[E]!=null&&W.auto(n,Ps))&&(V[U]=se)}for(let U in S){let W=S[U];V[U]==null&&W.from!=null&&V[W.from]!=null&&(V[U]=se)}V[E]!=null&&de(!0);let x={};for(let U in V){let W=V[U];if(W!=null){let j=x[U]=Po(S[U],wE);if(W.min!=null)xn(j,W);else if(U!=E||s==2)if(sn==0&&j.from==null){let lt=j.range(n,null,null,U);j.min=lt[0],j.max=lt[1]}else j.min=Ve,j.max=-Ve}}if(sn>0){v.forEach((U,W)=>{if(s==1){let j=U.scale,lt=V[j];if(lt==null)return;let mt=x[j];if(W==0){let Mt=mt.range(n,mt.min,mt.max,j);mt.min=Mt[0],mt.max=Mt[1],cn=Vi(mt.min,t[0]),hn=Vi(mt.max,t[0]),hn-cn>1&&(t[0][cn]<mt.min&&cn++,t[0][hn]>mt.max&&hn--),U.min=ai[cn],U.max=ai[hn]}else U.show&&U.auto&&Gt(mt,lt,U,t[W],U.sorted);U.idxs[0]=cn,U.idxs[1]=hn}else if(W>0&&U.show&&U.auto){let[j,lt]=U.facets,mt=j.scale,Mt=lt.scale,[Ft,Ot]=t[W],kt=x[mt],ae=x[Mt];kt!=null&&Gt(kt,V[mt],j,Ft,j.sorted),ae!=null&&Gt(ae,V[Mt],lt,Ot,lt.sorted),U.min=lt.min,U.max=lt.max}});for(let U in x){let W=x[U],j=V[U];if(W.from==null&&(j==null||j.min==null)){let lt=W.range(n,W.min==Ve?null:W.min,W.max==-Ve?null:W.max,U);W.min=lt[0],W.max=lt[1]}}}for(let U in x){let W=x[U];if(W.from!=null){let j=x[W.from];if(j.min==null)W.min=W.max=null;else{let lt=W.range(n,j.min,j.max,U);W.min=lt[0],W.max=lt[1]}}}let w={},L=!1;for(let U in x){let W=x[U],j=S[U];if(j.min!=W.min||j.max!=W.max){j.min=W.min,j.max=W.max;let lt=j.distr;j._min=lt==3?As(j.min):lt==4?nd(j.min,j.asinh):lt==100?j.fwd(j.min):j.min,j._max=lt==3?As(j.max):lt==4?nd(j.max,j.asinh):lt==100?j.fwd(j.max):j.max,w[U]=L=!0}}if(L){v.forEach((U,W)=>{s==2?W>0&&w.y&&(U._paths=null):w[U.scale]&&(U._paths=null)});for(let U in w)St=!0,In("setScale",U);_t&&ft.left>=0&&(it=gt=!0)}for(let U in V)V[U]=null}function Vt(x){let w=hd(cn-1,0,sn-1),L=hd(hn+1,0,sn-1);for(;x[w]==null&&w>0;)w--;for(;x[L]==null&&L<sn-1;)L++;return[w,L]}function _e(){if(sn>0){let x=v.some(w=>w._focus)&&Dt!=zt.alpha;x&&(u.globalAlpha=Dt=zt.alpha),v.forEach((w,L)=>{if(L>0&&w.show&&(Qe(L,!1),Qe(L,!0),w._paths==null)){let U=Dt;Dt!=w.alpha&&(u.globalAlpha=Dt=w.alpha);let W=s==2?[0,t[L][0].length-1]:Vt(t[L]);w._paths=w.paths(n,L,W[0],W[1]),Dt!=U&&(u.globalAlpha=Dt=U)}}),v.forEach((w,L)=>{if(L>0&&w.show){let U=Dt;Dt!=w.alpha&&(u.globalAlpha=Dt=w.alpha),w._paths!=null&&Ue(L,!1);{let W=w._paths!=null?w._paths.gaps:null,j=w.points.show(n,L,cn,hn,W),lt=w.points.filter(n,L,j,W);(j||lt)&&(w.points._paths=w.points.paths(n,L,cn,hn,lt),Ue(L,!0))}Dt!=U&&(u.globalAlpha=Dt=U),In("drawSeries",L)}}),x&&(u.globalAlpha=Dt=1)}}function Qe(x,w){let L=w?v[x].points:v[x];L._stroke=L.stroke(n,x),L._fill=L.fill(n,x)}function Ue(x,w){let L=w?v[x].points:v[x],{stroke:U,fill:W,clip:j,flags:lt,_stroke:mt=L._stroke,_fill:Mt=L._fill,_width:Ft=L.width}=L._paths;Ft=Ge(Ft*Ie,3);let Ot=null,kt=Ft%2/2;w&&Mt==null&&(Mt=Ft>0?"#fff":mt);let ae=L.pxAlign==1&&kt>0;if(ae&&u.translate(kt,kt),!w){let Ce=I-Ft/2,Ee=M-Ft/2,ye=q+Ft,te=ut+Ft;Ot=new Path2D,Ot.rect(Ce,Ee,ye,te)}w?Bt(mt,Ft,L.dash,L.cap,Mt,U,W,lt,j):Fe(x,mt,Ft,L.dash,L.cap,Mt,U,W,lt,Ot,j),ae&&u.translate(-kt,-kt)}function Fe(x,w,L,U,W,j,lt,mt,Mt,Ft,Ot){let kt=!1;Mt!=0&&P.forEach((ae,Ce)=>{if(ae.series[0]==x){let Ee=v[ae.series[1]],ye=t[ae.series[1]],te=(Ee._paths||Za).band;Ks(te)&&(te=ae.dir==1?te[0]:te[1]);let Yt,$e=null;Ee.show&&te&&_E(ye,cn,hn)?($e=ae.fill(n,Ce)||j,Yt=Ee._paths.clip):te=null,Bt(w,L,U,W,$e,lt,mt,Mt,Ft,Ot,Yt,te),kt=!0}}),kt||Bt(w,L,U,W,j,lt,mt,Mt,Ft,Ot)}let vn=Io|dd;function Bt(x,w,L,U,W,j,lt,mt,Mt,Ft,Ot,kt){Ct(x,w,L,U,W),(Mt||Ft||kt)&&(u.save(),Mt&&u.clip(Mt),Ft&&u.clip(Ft)),kt?(mt&vn)==vn?(u.clip(kt),Ot&&u.clip(Ot),ve(W,lt),dn(x,j,w)):mt&dd?(ve(W,lt),u.clip(kt),dn(x,j,w)):mt&Io&&(u.save(),u.clip(kt),Ot&&u.clip(Ot),ve(W,lt),u.restore(),dn(x,j,w)):(ve(W,lt),dn(x,j,w)),(Mt||Ft||kt)&&u.restore()}function dn(x,w,L){L>0&&(w instanceof Map?w.forEach((U,W)=>{u.strokeStyle=Cr=W,u.stroke(U)}):w!=null&&x&&u.stroke(w))}function ve(x,w){w instanceof Map?w.forEach((L,U)=>{u.fillStyle=Is=U,u.fill(L)}):w!=null&&x&&u.fill(w)}function fs(x,w,L,U){let W=C[x],j;if(U<=0)j=[0,0];else{let lt=W._space=W.space(n,x,w,L,U),mt=W._incrs=W.incrs(n,x,w,L,U,lt);j=B1(w,L,mt,U,lt)}return W._found=j}function pn(x,w,L,U,W,j,lt,mt,Mt,Ft){let Ot=lt%2/2;y==1&&u.translate(Ot,Ot),Ct(mt,lt,Mt,Ft,mt),u.beginPath();let kt,ae,Ce,Ee,ye=W+(U==0||U==3?-j:j);L==0?(ae=W,Ee=ye):(kt=W,Ce=ye);for(let te=0;te<x.length;te++)w[te]!=null&&(L==0?kt=Ce=x[te]:ae=Ee=x[te],u.moveTo(kt,ae),u.lineTo(Ce,Ee));u.stroke(),y==1&&u.translate(-Ot,-Ot)}function Pr(x){let w=!0;return C.forEach((L,U)=>{if(!L.show)return;let W=S[L.scale];if(W.min==null){L._show&&(w=!1,L._show=!1,de(!1));return}else L._show||(w=!1,L._show=!0,de(!1));let j=L.side,lt=j%2,{min:mt,max:Mt}=W,[Ft,Ot]=fs(U,mt,Mt,lt==0?k:Lt);if(Ot==0)return;let kt=W.distr==2,ae=L._splits=L.splits(n,U,mt,Mt,Ft,Ot,kt),Ce=W.distr==2?ae.map(Yt=>ai[Yt]):ae,Ee=W.distr==2?ai[ae[1]]-ai[ae[0]]:Ft,ye=L._values=L.values(n,L.filter(n,Ce,U,Ot,Ee),U,Ot,Ee);L._rotate=j==2?L.rotate(n,ye,U,Ot):0;let te=L._size;L._size=Ei(L.size(n,ye,U,x)),te!=null&&L._size!=te&&(w=!1)}),w}function qi(x){let w=!0;return Oo.forEach((L,U)=>{let W=L(n,U,Wi,x);W!=Ai[U]&&(w=!1),Ai[U]=W}),w}function ds(){for(let x=0;x<C.length;x++){let w=C[x];if(!w.show||!w._show)continue;let L=w.side,U=L%2,W,j,lt=w.stroke(n,x),mt=L==0||L==3?-1:1,[Mt,Ft]=w._found;if(w.label!=null){let qn=w.labelGap*mt,hi=En((w._lpos+qn)*Ie);Nt(w.labelFont[0],lt,"center",L==2?"top":Qg),u.save(),U==1?(W=j=0,u.translate(hi,En(M+ut/2)),u.rotate((L==3?-Vh:Vh)/2)):(W=En(I+q/2),j=hi);let ir=G0(w.label)?w.label(n,x,Mt,Ft):w.label;u.fillText(ir,W,j),u.restore()}if(Ft==0)continue;let Ot=S[w.scale],kt=U==0?q:ut,ae=U==0?I:M,Ce=w._splits,Ee=Ot.distr==2?Ce.map(qn=>ai[qn]):Ce,ye=Ot.distr==2?ai[Ce[1]]-ai[Ce[0]]:Mt,te=w.ticks,Yt=w.border,$e=te.show?te.size:0,on=En($e*Ie),Ln=En((w.alignTo==2?w._size-$e-w.gap:w.gap)*Ie),ke=w._rotate*-Vh/180,an=p(w._pos*Ie),li=(on+Ln)*mt,Xn=an+li;j=U==0?Xn:0,W=U==1?Xn:0;let vi=w.font[0],Ci=w.align==1?To:w.align==2?Qf:ke>0?To:ke<0?Qf:U==0?"center":L==3?Qf:To,Zi=ke||U==1?"middle":L==2?"top":Qg;Nt(vi,lt,Ci,Zi);let ci=w.font[1]*w.lineGap,Si=Ce.map(qn=>p(a(qn,Ot,kt,ae))),Ri=w._values;for(let qn=0;qn<Ri.length;qn++){let hi=Ri[qn];if(hi!=null){U==0?W=Si[qn]:j=Si[qn],hi=""+hi;let ir=hi.indexOf(`
`)==-1?[hi]:hi.split(/\n/gm);for(let $n=0;$n<ir.length;$n++){let tp=ir[$n];ke?(u.save(),u.translate(W,j+$n*ci),u.rotate(ke),u.fillText(tp,0,0),u.restore()):u.fillText(tp,W,j+$n*ci)}}}te.show&&pn(Si,te.filter(n,Ee,x,Ft,ye),U,L,an,on,Ge(te.width*Ie,3),te.stroke(n,x),te.dash,te.cap);let Ji=w.grid;Ji.show&&pn(Si,Ji.filter(n,Ee,x,Ft,ye),U,U==0?2:1,U==0?M:I,U==0?ut:q,Ge(Ji.width*Ie,3),Ji.stroke(n,x),Ji.dash,Ji.cap),Yt.show&&pn([an],[1],U==0?1:0,U==0?1:2,U==1?M:I,U==1?ut:q,Ge(Yt.width*Ie,3),Yt.stroke(n,x),Yt.dash,Yt.cap)}In("drawAxes")}function de(x){v.forEach((w,L)=>{L>0&&(w._paths=null,x&&(s==1?(w.min=null,w.max=null):w.facets.forEach(U=>{U.min=null,U.max=null})))})}let rn=!1,Wn=!1,Oe=[];function mn(){Wn=!1;for(let x=0;x<Oe.length;x++)In(...Oe[x]);Oe.length=0}function kn(){rn||(IE(Fd),rn=!0)}function tl(x,w=!1){rn=!0,Wn=w,x(n),Fd(),w&&Oe.length>0&&queueMicrotask(mn)}n.batch=tl;function Fd(){if(at&&(ge(),at=!1),St&&(Et(),St=!1),yt){if(Ze(d,To,Qt),Ze(d,"top",ce),Ze(d,Xa,k),Ze(d,qa,Lt),Ze(m,To,Qt),Ze(m,"top",ce),Ze(m,Xa,k),Ze(m,qa,Lt),Ze(f,Xa,nn),Ze(f,qa,fn),h.width=En(nn*Ie),h.height=En(fn*Ie),C.forEach(({_el:x,_show:w,_size:L,_pos:U,side:W})=>{if(x!=null)if(w){let j=W===3||W===0?L:0,lt=W%2==1;Ze(x,lt?"left":"top",U-j),Ze(x,lt?"width":"height",L),Ze(x,lt?"top":"left",lt?ce:Qt),Ze(x,lt?"height":"width",lt?Lt:k),ld(x,Mr)}else _i(x,Mr)}),Cr=Is=Rr=z=Q=Y=Z=At=T=null,Dt=1,Go(!0),Qt!=Tt||ce!=ze||k!=Ht||Lt!=Kt){de(!1);let x=k/Ht,w=Lt/Kt;if(_t&&!it&&ft.left>=0){ft.left*=x,ft.top*=w,Ir&&cs(Ir,En(ft.left),0,k,Lt),Lr&&cs(Lr,0,En(ft.top),k,Lt);for(let L=0;L<ue.length;L++){let U=ue[L];U!=null&&(We[L]*=x,Hn[L]*=w,cs(U,Ei(We[L]),Ei(Hn[L]),k,Lt))}}if(qe.show&&!rt&&qe.left>=0&&qe.width>0){qe.left*=x,qe.width*=x,qe.top*=w,qe.height*=w;for(let L in hu)Ze(Ur,L,qe[L])}Tt=Qt,ze=ce,Ht=k,Kt=Lt}In("setSize"),yt=!1}nn>0&&fn>0&&(u.clearRect(0,0,h.width,h.height),In("drawClear"),b.forEach(x=>x()),In("draw")),qe.show&&rt&&(el(qe),rt=!1),_t&&it&&(nr(null,!0,!1),it=!1),pt.show&&pt.live&&gt&&(lu(),gt=!1),l||(l=!0,n.status=1,In("ready")),Ps=!1,rn=!1}n.redraw=(x,w)=>{St=w||!1,x!==!1?Ds(E,A.min,A.max):kn()};function ru(x,w){let L=S[x];if(L.from==null){if(sn==0){let U=L.range(n,w.min,w.max,x);w.min=U[0],w.max=U[1]}if(w.min>w.max){let U=w.min;w.min=w.max,w.max=U}if(sn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;x==E&&L.distr==2&&sn>0&&(w.min=Vi(w.min,t[0]),w.max=Vi(w.max,t[0]),w.min==w.max&&w.max++),V[x]=w,at=!0,kn()}}n.setScale=ru;let ou,au,Ir,Lr,Od,Bd,Dr,Nr,kd,zd,Xe,Ke,Ls=!1,Fn=ft.drag,Rn=Fn.x,Pn=Fn.y;_t&&(ft.x&&(ou=Ti(eE,m)),ft.y&&(au=Ti(nE,m)),A.ori==0?(Ir=ou,Lr=au):(Ir=au,Lr=ou),Xe=ft.left,Ke=ft.top);let qe=n.select=xn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Ur=qe.show?Ti(tE,qe.over?m:d):null;function el(x,w){if(qe.show){for(let L in x)qe[L]=x[L],L in hu&&Ze(Ur,L,x[L]);w!==!1&&In("setSelect")}}n.setSelect=el;function J_(x){if(v[x].show)et&&ld(le[x],Mr);else if(et&&_i(le[x],Mr),_t){let L=It?ue[0]:ue[x];L!=null&&cs(L,-10,-10,k,Lt)}}function Ds(x,w,L){ru(x,{min:w,max:L})}function $i(x,w,L,U){w.focus!=null&&ex(x),w.show!=null&&v.forEach((W,j)=>{j>0&&(x==j||x==null)&&(W.show=w.show,J_(j),s==2?(Ds(W.facets[0].scale,null,null),Ds(W.facets[1].scale,null,null)):Ds(W.scale,null,null),kn())}),L!==!1&&In("setSeries",x,w),U&&Ho("setSeries",n,x,w)}n.setSeries=$i;function K_(x,w){xn(P[x],w)}function j_(x,w){x.fill=Me(x.fill||null),x.dir=Ae(x.dir,-1),w=w??P.length,P.splice(w,0,x)}function Q_(x){x==null?P.length=0:P.splice(x,1)}n.addBand=j_,n.setBand=K_,n.delBand=Q_;function tx(x,w){v[x].alpha=w,_t&&ue[x]!=null&&(ue[x].style.opacity=w),et&&le[x]&&(le[x].style.opacity=w)}let ps,Ns,er,Fr={focus:!0};function ex(x){if(x!=er){let w=x==null,L=zt.alpha!=1;v.forEach((U,W)=>{if(s==1||W>0){let j=w||W==0||W==x;U._focus=w?null:j,L&&tx(W,j?1:zt.alpha)}}),er=x,L&&kn()}}et&&ne&&be(i0,Pt,x=>{ft._lock||(ee(x),er!=null&&$i(null,Fr,!0,gn.setSeries))});function Yi(x,w,L){let U=S[w];L&&(x=x/Ie-(U.ori==1?ce:Qt));let W=k;U.ori==1&&(W=Lt,x=W-x),U.dir==-1&&(x=W-x);let j=U._min,lt=U._max,mt=x/W,Mt=j+(lt-j)*mt,Ft=U.distr;return Ft==3?Co(10,Mt):Ft==4?yE(Mt,U.asinh):Ft==100?U.bwd(Mt):Mt}function nx(x,w){let L=Yi(x,E,w);return Vi(L,t[0],cn,hn)}n.valToIdx=x=>Vi(x,t[0]),n.posToIdx=nx,n.posToVal=Yi,n.valToPos=(x,w,L)=>S[w].ori==0?r(x,S[w],L?q:k,L?I:0):o(x,S[w],L?ut:Lt,L?M:0),n.setCursor=(x,w,L)=>{Xe=x.left,Ke=x.top,nr(null,w,L)};function Vd(x,w){Ze(Ur,To,qe.left=x),Ze(Ur,Xa,qe.width=w)}function Gd(x,w){Ze(Ur,"top",qe.top=x),Ze(Ur,qa,qe.height=w)}let zo=A.ori==0?Vd:Gd,Vo=A.ori==1?Vd:Gd;function ix(){if(et&&pt.live)for(let x=s==2?1:0;x<v.length;x++){if(x==0&&fe)continue;let w=pt.values[x],L=0;for(let U in w)Xt[x][L++].firstChild.nodeValue=w[U]}}function lu(x,w){if(x!=null&&(x.idxs?x.idxs.forEach((L,U)=>{nt[U]=L}):bE(x.idx)||nt.fill(x.idx),pt.idx=nt[0]),et&&pt.live){for(let L=0;L<v.length;L++)(L>0||s==1&&!fe)&&sx(L,nt[L]);ix()}gt=!1,w!==!1&&In("setLegend")}n.setLegend=lu;function sx(x,w){let L=v[x],U=x==0&&F==2?ai:t[x],W;fe?W=L.values(n,x,w)??oe:(W=L.value(n,w==null?null:U[w],x,w),W=W==null?oe:{_:W}),pt.values[x]=W}function nr(x,w,L){kd=Xe,zd=Ke,[Xe,Ke]=ft.move(n,Xe,Ke),ft.left=Xe,ft.top=Ke,_t&&(Ir&&cs(Ir,En(Xe),0,k,Lt),Lr&&cs(Lr,0,En(Ke),k,Lt));let U,W=cn>hn;ps=Ve,Ns=null;let j=A.ori==0?k:Lt,lt=A.ori==1?k:Lt;if(Xe<0||sn==0||W){U=ft.idx=null;for(let mt=0;mt<v.length;mt++){let Mt=ue[mt];Mt!=null&&cs(Mt,-10,-10,k,Lt)}ne&&$i(null,Fr,!0,x==null&&gn.setSeries),pt.live&&(nt.fill(U),gt=!0)}else{let mt,Mt,Ft;s==1&&(mt=A.ori==0?Xe:Ke,Mt=Yi(mt,E),U=ft.idx=Vi(Mt,t[0],cn,hn),Ft=G(t[0][U],A,j,0));let Ot=-10,kt=-10,ae=0,Ce=0,Ee=!0,ye="",te="";for(let Yt=s==2?1:0;Yt<v.length;Yt++){let $e=v[Yt],on=nt[Yt],Ln=on==null?null:s==1?t[Yt][on]:t[Yt][1][on],ke=ft.dataIdx(n,Yt,U,Mt),an=ke==null?null:s==1?t[Yt][ke]:t[Yt][1][ke];if(gt=gt||an!=Ln||ke!=on,nt[Yt]=ke,Yt>0&&$e.show){let li=ke==null?-10:ke==U?Ft:G(s==1?t[0][ke]:t[Yt][0][ke],A,j,0),Xn=an==null?-10:N(an,s==1?S[$e.scale]:S[$e.facets[1].scale],lt,0);if(ne&&an!=null){let vi=A.ori==1?Xe:Ke,Ci=An(zt.dist(n,Yt,ke,Xn,vi));if(Ci<ps){let Zi=zt.bias;if(Zi!=0){let ci=Yi(vi,$e.scale),Si=an>=0?1:-1,Ri=ci>=0?1:-1;Ri==Si&&(Ri==1?Zi==1?an>=ci:an<=ci:Zi==1?an<=ci:an>=ci)&&(ps=Ci,Ns=Yt)}else ps=Ci,Ns=Yt}}if(gt||It){let vi,Ci;A.ori==0?(vi=li,Ci=Xn):(vi=Xn,Ci=li);let Zi,ci,Si,Ri,Ji,qn,hi=!0,ir=ht.bbox;if(ir!=null){hi=!1;let $n=ir(n,Yt);Si=$n.left,Ri=$n.top,Zi=$n.width,ci=$n.height}else Si=vi,Ri=Ci,Zi=ci=ht.size(n,Yt);if(qn=ht.fill(n,Yt),Ji=ht.stroke(n,Yt),It)Yt==Ns&&ps<=zt.prox&&(Ot=Si,kt=Ri,ae=Zi,Ce=ci,Ee=hi,ye=qn,te=Ji);else{let $n=ue[Yt];$n!=null&&(We[Yt]=Si,Hn[Yt]=Ri,h0($n,Zi,ci,hi),l0($n,qn,Ji),cs($n,Ei(Si),Ei(Ri),k,Lt))}}}}if(It){let Yt=zt.prox,$e=er==null?ps<=Yt:ps>Yt||Ns!=er;if(gt||$e){let on=ue[0];on!=null&&(We[0]=Ot,Hn[0]=kt,h0(on,ae,Ce,Ee),l0(on,ye,te),cs(on,Ei(Ot),Ei(kt),k,Lt))}}}if(qe.show&&Ls)if(x!=null){let[mt,Mt]=gn.scales,[Ft,Ot]=gn.match,[kt,ae]=x.cursor.sync.scales,Ce=x.cursor.drag;if(Rn=Ce._x,Pn=Ce._y,Rn||Pn){let{left:Ee,top:ye,width:te,height:Yt}=x.select,$e=x.scales[kt].ori,on=x.posToVal,Ln,ke,an,li,Xn,vi=mt!=null&&Ft(mt,kt),Ci=Mt!=null&&Ot(Mt,ae);vi&&Rn?($e==0?(Ln=Ee,ke=te):(Ln=ye,ke=Yt),an=S[mt],li=G(on(Ln,kt),an,j,0),Xn=G(on(Ln+ke,kt),an,j,0),zo(Gi(li,Xn),An(Xn-li))):zo(0,j),Ci&&Pn?($e==1?(Ln=Ee,ke=te):(Ln=ye,ke=Yt),an=S[Mt],li=N(on(Ln,ae),an,lt,0),Xn=N(on(Ln+ke,ae),an,lt,0),Vo(Gi(li,Xn),An(Xn-li))):Vo(0,lt)}else uu()}else{let mt=An(kd-Od),Mt=An(zd-Bd);if(A.ori==1){let ae=mt;mt=Mt,Mt=ae}Rn=Fn.x&&mt>=Fn.dist,Pn=Fn.y&&Mt>=Fn.dist;let Ft=Fn.uni;Ft!=null?Rn&&Pn&&(Rn=mt>=Ft,Pn=Mt>=Ft,!Rn&&!Pn&&(Mt>mt?Pn=!0:Rn=!0)):Fn.x&&Fn.y&&(Rn||Pn)&&(Rn=Pn=!0);let Ot,kt;Rn&&(A.ori==0?(Ot=Dr,kt=Xe):(Ot=Nr,kt=Ke),zo(Gi(Ot,kt),An(kt-Ot)),Pn||Vo(0,lt)),Pn&&(A.ori==1?(Ot=Dr,kt=Xe):(Ot=Nr,kt=Ke),Vo(Gi(Ot,kt),An(kt-Ot)),Rn||zo(0,j)),!Rn&&!Pn&&(zo(0,0),Vo(0,0))}if(Fn._x=Rn,Fn._y=Pn,x==null){if(L){if(Qd!=null){let[mt,Mt]=gn.scales;gn.values[0]=mt!=null?Yi(A.ori==0?Xe:Ke,mt):null,gn.values[1]=Mt!=null?Yi(A.ori==1?Xe:Ke,Mt):null}Ho(td,n,Xe,Ke,k,Lt,U)}if(ne){let mt=L&&gn.setSeries,Mt=zt.prox;er==null?ps<=Mt&&$i(Ns,Fr,!0,mt):ps>Mt?$i(null,Fr,!0,mt):Ns!=er&&$i(Ns,Fr,!0,mt)}}gt&&(pt.idx=U,lu()),w!==!1&&In("setCursor")}let Us=null;Object.defineProperty(n,"rect",{get(){return Us==null&&Go(!1),Us}});function Go(x=!1){x?Us=null:(Us=m.getBoundingClientRect(),In("syncRect",Us))}function Hd(x,w,L,U,W,j,lt){ft._lock||Ls&&x!=null&&x.movementX==0&&x.movementY==0||(cu(x,w,L,U,W,j,lt,!1,x!=null),x!=null?nr(null,!0,!0):nr(w,!0,!1))}function cu(x,w,L,U,W,j,lt,mt,Mt){if(Us==null&&Go(!1),ee(x),x!=null)L=x.clientX-Us.left,U=x.clientY-Us.top;else{if(L<0||U<0){Xe=-10,Ke=-10;return}let[Ft,Ot]=gn.scales,kt=w.cursor.sync,[ae,Ce]=kt.values,[Ee,ye]=kt.scales,[te,Yt]=gn.match,$e=w.axes[0].side%2==1,on=A.ori==0?k:Lt,Ln=A.ori==1?k:Lt,ke=$e?j:W,an=$e?W:j,li=$e?U:L,Xn=$e?L:U;if(Ee!=null?L=te(Ft,Ee)?a(ae,S[Ft],on,0):-10:L=on*(li/ke),ye!=null?U=Yt(Ot,ye)?a(Ce,S[Ot],Ln,0):-10:U=Ln*(Xn/an),A.ori==1){let vi=L;L=U,U=vi}}Mt&&(w==null||w.cursor.event.type==td)&&((L<=1||L>=k-1)&&(L=vr(L,k)),(U<=1||U>=Lt-1)&&(U=vr(U,Lt))),mt?(Od=L,Bd=U,[Dr,Nr]=ft.move(n,L,U)):(Xe=L,Ke=U)}let hu={width:0,height:0,left:0,top:0};function uu(){el(hu,!1)}let Wd,Xd,qd,$d;function Yd(x,w,L,U,W,j,lt){Ls=!0,Rn=Pn=Fn._x=Fn._y=!1,cu(x,w,L,U,W,j,lt,!0,!1),x!=null&&(be(ed,od,Zd,!1),Ho(e0,n,Dr,Nr,k,Lt,null));let{left:mt,top:Mt,width:Ft,height:Ot}=qe;Wd=mt,Xd=Mt,qd=Ft,$d=Ot}function Zd(x,w,L,U,W,j,lt){Ls=Fn._x=Fn._y=!1,cu(x,w,L,U,W,j,lt,!1,!0);let{left:mt,top:Mt,width:Ft,height:Ot}=qe,kt=Ft>0||Ot>0,ae=Wd!=mt||Xd!=Mt||qd!=Ft||$d!=Ot;if(kt&&ae&&el(qe),Fn.setScale&&kt&&ae){let Ce=mt,Ee=Ft,ye=Mt,te=Ot;if(A.ori==1&&(Ce=Mt,Ee=Ot,ye=mt,te=Ft),Rn&&Ds(E,Yi(Ce,E),Yi(Ce+Ee,E)),Pn)for(let Yt in S){let $e=S[Yt];Yt!=E&&$e.from==null&&$e.min!=Ve&&Ds(Yt,Yi(ye+te,Yt),Yi(ye,Yt))}uu()}else ft.lock&&(ft._lock=!ft._lock,nr(w,!0,x!=null));x!=null&&(yn(ed,od),Ho(ed,n,Xe,Ke,k,Lt,null))}function rx(x,w,L,U,W,j,lt){if(ft._lock)return;ee(x);let mt=Ls;if(Ls){let Mt=!0,Ft=!0,Ot=10,kt,ae;A.ori==0?(kt=Rn,ae=Pn):(kt=Pn,ae=Rn),kt&&ae&&(Mt=Xe<=Ot||Xe>=k-Ot,Ft=Ke<=Ot||Ke>=Lt-Ot),kt&&Mt&&(Xe=Xe<Dr?0:k),ae&&Ft&&(Ke=Ke<Nr?0:Lt),nr(null,!0,!0),Ls=!1}Xe=-10,Ke=-10,nt.fill(null),nr(null,!0,!0),mt&&(Ls=mt)}function Jd(x,w,L,U,W,j,lt){ft._lock||(ee(x),ko(),uu(),x!=null&&Ho(s0,n,Xe,Ke,k,Lt,null))}function Kd(){C.forEach(k1),B(n.width,n.height,!0)}br(Gh,Ao,Kd);let Or={};Or.mousedown=Yd,Or.mousemove=Hd,Or.mouseup=Zd,Or.dblclick=Jd,Or.setSeries=(x,w,L,U)=>{let W=gn.match[2];L=W(n,w,L),L!=-1&&$i(L,U,!0,!1)},_t&&(be(e0,m,Yd),be(td,m,Hd),be(n0,m,x=>{ee(x),Go(!1)}),be(i0,m,rx),be(s0,m,Jd),pd.add(n),n.syncRect=Go);let nl=n.hooks=i.hooks||{};function In(x,w,L){Wn?Oe.push([x,w,L]):x in nl&&nl[x].forEach(U=>{U.call(null,n,w,L)})}(i.plugins||[]).forEach(x=>{for(let w in x.hooks)nl[w]=(nl[w]||[]).concat(x.hooks[w])});let jd=(x,w,L)=>L,gn=xn({key:null,setSeries:!1,filters:{pub:m0,sub:m0},scales:[E,v[1]?v[1].scale:null],match:[g0,g0,jd],values:[null,null]},ft.sync);gn.match.length==2&&gn.match.push(jd),ft.sync=gn;let Qd=gn.key,fu=f_(Qd);function Ho(x,w,L,U,W,j,lt){gn.filters.pub(x,w,L,U,W,j,lt)&&fu.pub(x,w,L,U,W,j,lt)}fu.sub(n);function ox(x,w,L,U,W,j,lt){gn.filters.sub(x,w,L,U,W,j,lt)&&Or[x](null,w,L,U,W,j,lt)}n.pub=ox;function ax(){fu.unsub(n),pd.delete(n),Cn.clear(),cd(Gh,Ao,Kd),c.remove(),Pt?.remove(),In("destroy")}n.destroy=ax;function du(){In("init",i,t),Bo(t||i.data,!1),V[E]?ru(E,V[E]):ko(),rt=qe.show&&(qe.width>0||qe.height>0),it=gt=!0,B(i.width,i.height)}return v.forEach(Ar),C.forEach(hs),e?e instanceof HTMLElement?(e.appendChild(c),du()):e(n,du):du(),n}Bn.assign=xn;Bn.fmtNum=Sd;Bn.rangeNum=Hh;Bn.rangeLog=qh;Bn.rangeAsinh=yd;Bn.orient=Tr;Bn.pxRatio=Ie;Bn.join=PE;Bn.fmtDate=bd,Bn.tzDate=VE;Bn.sync=f_;{Bn.addGap=b1,Bn.clipGaps=Zh;let i=Bn.paths={points:x_};i.linear=v_,i.stepped=E1,i.bars=A1,i.spline=R1}var z1=20,V1=["up","align x","align depth","approach","fine"];function w_(i){let t=Rt("servo-plot"),e=[],n=[[],[],[]],s={stroke:"#9fb0bd",grid:{stroke:"#263642",width:1},ticks:{show:!1},font:"11px system-ui"},r=(l,c)=>({label:l,stroke:c,width:1.5,points:{show:!1}}),o=new Bn({width:Math.max(t.clientWidth,120),height:118,legend:{show:!0,live:!1},cursor:{show:!1},scales:{x:{time:!1}},axes:[{...s,size:22,values:(l,c)=>c.map(h=>`${h} s`)},{...s,size:38}],series:[{},r("x px","#4fb3ff"),r("y px","#7fd18b"),r("d mm","#f2a33a")]},[[],[],[],[]],t);new ResizeObserver(()=>o.setSize({width:Math.max(t.clientWidth,120),height:118})).observe(t);let a=ii(()=>{let l=e[e.length-1];o.setData([e.map(c=>Math.round((c-l)*100)/100),...n])});i.follow("(servo ?state ?object ?x ?y ?d)",l=>{if(l.length===0){Rt("servo-note").textContent="at rest";return}let[,c,h,...u]=dt(l[0]);for(Rt("servo-note").textContent=`${V1[c]??c}: ${J(h)}`,e.push(l[0].facts[0].when/1e6),u.forEach((f,d)=>n[d].push(f));e[0]<e[e.length-1]-z1;){e.shift();for(let f of n)f.shift()}a()})}var G1=1e3,H1="Escape, from anywhere",T_="use the button at the cell";function E_(i,t){let e=Rt("stop-note"),n=c=>e.textContent=c,s=Rt("stop-alarm"),r=c=>{s.textContent=c,s.hidden=c===""},o=async()=>{let c=setTimeout(()=>r(`STOP is not confirmed: ${T_}`),G1);try{await i.stop("the operator's STOP"),n("STOP is told"),r("")}catch(h){r(`STOP is not confirmed: ${T_} (${Te(h)})`)}clearTimeout(c)};Rt("stop").addEventListener("click",o),Rt("confirm-stop").addEventListener("click",()=>{o(),Rt("confirm").close()});let a=c=>{c.key==="Escape"&&!c.repeat&&o()};window.addEventListener("keydown",a,{capture:!0});let l=Rt("clear-stops");l.addEventListener("click",async()=>{if(await pl("Is everybody out of the way? Clearing the stop lets the arm move again."))try{await i.clearStops()}catch(c){n(Te(c))}}),t.onChange(c=>{l.disabled=!c,l.title=c?"":`${t.why}: who clears a stop sets the arm free`}),i.followAlways("(stop ?who ?reason)",c=>{Rt("stopped").hidden=c.length===0,c.length>0?r(""):n(H1);let h=c.map(u=>`${J(dt(u)[1])}: ${J(dt(u)[2])}`);Rt("stopped-by").textContent=Jt(h.join("; "))})}var Pd=50,W1={reached:"good",running:"busy",kept:"good"},X1=i=>Array.isArray(i)&&J(i[0])==="fail"?J(i[2]):"";function A_(i){let t=R("span",{class:"quiet"},""),e=R("tbody",{}),n=["","Goal","Outcome","Since"].map(l=>R("th",{},l)),s=R("table",{id:"goals"},R("thead",{},R("tr",{},...n)),e),r=new Map,o=new Map,a=()=>{let l=[...new Set([...r.keys(),...o.keys()])].sort((h,u)=>u-h);t.textContent=l.length>Pd?`${l.length}, ${Pd} shown`:String(l.length);let c=l.slice(0,Pd).map(h=>{let u=o.get(h),f=u?J(dt(u)[2]):"asked for",d=u?X1(dt(u)[3]):"";return R("tr",{},R("td",{},String(h)),R("td",{},R("code",{},Jt((r.get(h)??[]).map(we).join(" "),200))),R("td",{},R("span",{class:`chip ${W1[f]??"warn"}`},f),d&&` ${Jt(d)}`),R("td",{},u?tn(u.facts[0].when):""))});e.replaceChildren(...c)};return i.follow("(goal ?n ?facts)",l=>{r=new Map(l.map(dt).map(([,c,h])=>[c,h])),a()}),i.follow("(goal-state ?n ?state ?detail)",l=>{o=new Map(l.map(c=>[dt(c)[1],c])),a()}),R("details",{class:"goals"},R("summary",{},"Goals so far ",t),s)}function C_(i,t,e){let n=R("canvas",{role:"img","aria-label":`What was seen at ${tn(e)}`,hidden:!0}),s=R("figcaption",{class:"quiet"},"looking for the picture \u2026");return(async()=>{if(!t)return s.textContent="no stream of images is told";try{let o=await i.picture(t,e);Tl(n,o),o.bitmap.close(),n.hidden=!1,s.textContent=`frame ${o.number}, ${tn(o.captured)}`}catch(o){s.textContent=Te(o)}})(),R("figure",{class:"kept"},n,s)}var q1=4e3,Id=({answer:i})=>i.facts[0].when,Qh=class{#t={servo:new Map,sightings:new Map};#e=null;#n;constructor(t,e){this.#n=e,t.followAlways("(servo ?state ?object ?x ?y ?d)",([n])=>this.#r(n)),t.followAlways("(tracked ?eyes ?name ?state ?frame ?confidence)",n=>{for(let s of n)this.#s("sightings",{answer:s,until:s.facts[0].when});e()}),t.earlierWork((n,s)=>{for(let r of s)this.#s(n,r);e()})}servo(t){return this.#i("servo",t)}sightings(t){return this.#i("sightings",t)}#i(t,e){return[...this.#t[t].values()].filter(n=>Id(n)<=e)}#s(t,e){let n=this.#t[t];if(n.set(e.answer.ids[0],e),n.size<=q1)return;let s=[...n].reduce((r,o)=>Id(o[1])<Id(r[1])?o:r);n.delete(s[0])}#r(t){let e=n=>dt(n).slice(1,3).join(" ");t&&this.#e&&(this.#e.until=t.facts[0].when),t?(!this.#e||e(this.#e.answer)!==e(t))&&(this.#e={answer:t,until:t.facts[0].when},this.#s("servo",this.#e)):this.#e=null,this.#n()}};var Rs=["Goals","Plans","Operations","Servo","Sightings","Differences","Refusals","Faults"],$1=["up","align x","align depth","approach","fine"],Y1={plan:"Plans",operation:"Operations",servo:"Servo",difference:"Differences",missing:"Differences",agent:"Faults"},Z1=new Set(["operation","plan","result","goal"]),Qs=i=>i.facts[0].when,J1=i=>Array.isArray(i)&&J(i[0])==="fail";function R_(i){let t=i.map(e=>({answer:e,event:dt(e),when:Qs(e)}));return t.flatMap(({answer:e,event:[,,n,s,r],when:o},a)=>{let l=J1(r),c=l?"Faults":Y1[J(n)];if(!c)return[];let h=c==="Operations"&&t.slice(a+1).find(({event:u})=>Z1.has(J(u[2])));return[{lane:c,from:o,until:h?h.when:o,kind:l?"bad":J(n),label:J(s),answer:e}]})}function P_(i,t,e){let n=new Map(t.map(s=>[dt(s)[1],s]));return i.flatMap(s=>{let[,r,o]=dt(s),a=n.get(r),l=a?J(dt(a)[2]):"asked for",c=`goal ${r} ${l}: ${o.map(we).join(" ")}`,h=a&&l!=="running"?Qs(a):e,u={lane:"Goals",from:Qs(s),until:h,kind:l,label:c,answer:a??s};return l==="refused"?[u,{...u,lane:"Refusals",from:h,kind:"bad"}]:[u]})}function I_(i){return i.map(t=>{let[,e,n,s,r]=dt(t),o=`${J(e)}: ${J(n)}, ${s} times: ${J(r)}`;return{lane:"Refusals",from:Qs(t),until:Qs(t),kind:"bad",label:o,answer:t}})}function L_(i){return i.map(({answer:t})=>{let[,e,n,s,r]=dt(t),o=`${J(e)}: ${J(n)} ${J(s)} since frame ${r}`;return{lane:"Sightings",from:Qs(t),until:Qs(t),kind:J(s),label:o,answer:t}})}function D_(i){return i.map(({answer:t,until:e})=>{let[,n,s]=dt(t),r=`servo ${$1[n]??n}: ${J(s)}`;return{lane:"Servo",from:Qs(t),until:e,kind:`state-${n}`,label:r,answer:t}})}function N_(i,t){let e=[],n=new Map;for(let s of i.toSorted((r,o)=>r.from-o.from)){let r=`${s.lane} ${s.kind}`,o=n.get(r);if(o&&s.from-o.from<t)o.marks.push(s),o.until=Math.max(o.until,s.until);else{let a={lane:s.lane,kind:s.kind,from:s.from,until:s.until,marks:[s]};n.set(r,a),e.push(a)}}return e}var tu=76,Er=19,Uo=18,U_=5,K1=15,j1=6e7,Ld=[1,2,5,10,20,60,120].map(i=>i*j1),Q1=i=>tn(i).slice(0,5);function F_({lane:i,marks:t,from:e}){let n=t.length>1?` and ${t.length-1} more`:"";return`${i}, ${tn(e)}: ${Jt(t[0].label,160)}${n}`}var tA={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]},eu=class{#t;#e=Sn("g",{});#n=Sn("g",{});#i=new Map;#s="";panel;constructor(t){this.#t=t;let e=Uo+Rs.length*Er;this.panel=Sn("svg",{id:"work",height:e,width:"100%",role:"group","aria-label":"What happened, over time"},this.#e,this.#n),this.panel.addEventListener("keydown",n=>this.#f(n))}draw(t,e,n){let s=Math.max(this.panel.clientWidth-tu-4,100),r=c=>tu+s*(Math.min(Math.max(c,e),n)-e)/(n-e),o=t.filter(c=>c.until>=e&&c.from<=n),a=N_(o,U_*(n-e)/s);this.#r(r,s,e,n);let l=new Map(a.map(c=>[`${c.lane} ${c.kind} ${c.from}`,c]));for(let[c,{made:h}]of this.#i)l.has(c)||(h.remove(),this.#i.delete(c));for(let[c,h]of l)this.#o(c,h,r);this.#c()}#r(t,e,n,s){let r=Ld.find(l=>(s-n)/l<=8)??Ld[Ld.length-1],o=[];for(let l=Math.ceil(n/r)*r;l<=s;l+=r)o.push(l);let a=Uo+Rs.length*Er;this.#e.replaceChildren(...Rs.map((l,c)=>Sn("text",{x:0,y:Uo+c*Er+13,class:"lane"},l)),...Rs.map((l,c)=>Sn("rect",{x:tu,y:Uo+c*Er+1,width:e,height:Er-2,class:"lane"})),...o.map(l=>Sn("line",{x1:t(l),x2:t(l),y1:Uo,y2:a,class:"tick"})),...o.filter(l=>t(l)<tu+e-K1).map(l=>Sn("text",{x:t(l),y:12,class:"tick"},Q1(l))))}#o(t,e,n){let s=this.#i.get(t)??this.#a(t,e);s.group=e,s.title.textContent=F_(e);let{made:r}=s,o=n(e.from);r.setAttribute("x",String(o)),r.setAttribute("y",String(Uo+Rs.indexOf(e.lane)*Er+3)),r.setAttribute("width",String(Math.max(n(e.until)-o,U_))),r.setAttribute("aria-label",F_(e))}#a(t,e){let n=Sn("title",{}),s=Sn("rect",{height:Er-6,rx:2,role:"button",tabindex:-1,class:`mark ${e.kind}`,"data-lane":e.lane},n);s.addEventListener("click",()=>this.#l(t)),s.addEventListener("focus",()=>{this.#s=t,this.#c()}),this.#n.append(s);let r={made:s,title:n,group:e};return this.#i.set(t,r),r}#l(t){let e=this.#i.get(t);e&&this.#t(e.group.marks)}#c(){this.#i.has(this.#s)||(this.#s=this.#u().at(-1)?.[0]??"");for(let[t,{made:e}]of this.#i)e.setAttribute("tabindex",t===this.#s?"0":"-1")}#u(){return[...this.#i].sort(([,t],[,e])=>t.group.from-e.group.from)}#f(t){let e=this.#i.get(this.#s);if(!e)return;if(t.key==="Enter"||t.key===" ")return t.preventDefault(),this.#l(this.#s);let n=tA[t.key],s=n&&(n[0]?this.#d(e,n[0]):this.#h(e,n[1]));s&&(t.preventDefault(),s.made.focus())}#d(t,e){let n=this.#u().filter(([,{group:s}])=>s.lane===t.group.lane);return n[n.findIndex(([,s])=>s===t)+e]?.[1]}#h(t,e){let n=({group:s})=>Math.abs(s.from-t.group.from);for(let s=Rs.indexOf(t.group.lane)+e;s>=0&&s<Rs.length;s+=e){let r=[...this.#i.values()].filter(({group:o})=>o.lane===Rs[s]);if(r.length)return r.sort((o,a)=>n(o)-n(a))[0]}}};var eA=[["10 minutes",6e8],["1 hour",36e8],["8 hours",8*36e8]],Dd=20,nA=5e3;function O_(i,t,e){let n=R("div",{class:"timeline",id:"opened",hidden:!0}),s=({answer:d,label:m})=>R("details",{},R("summary",{},R("time",{},tn(d.facts[0].when)),Jt(m)),R("p",{class:"quiet"},Vr(d.ids[0],d.facts[0]))),r=d=>{let m=d.slice(0,Dd).map(g=>dt(g.answer)[0].name==="event"?e(g.answer):s(g)),y=d.length>Dd?[R("p",{class:"quiet"},`and ${d.length-Dd} more`)]:[],p=R("button",{type:"button",class:"small",onclick:()=>n.hidden=!0},"Close");n.replaceChildren(p,...m,...y),n.hidden=!1,m[0].open=!0},o=new eu(r),a=R("select",{"aria-label":"How much of the past"},...eA.map(([d,m])=>R("option",{value:m,selected:d==="1 hour"},d))),l={goals:[],states:[],refusals:[]},c=ii(()=>{if(o.panel.clientWidth===0)return;let d=i.moment??Date.now()*1e3,m=d-Number(a.value);t.reach(m);let y=[...P_(l.goals,l.states,d),...R_(t.until(d)),...D_(h.servo(d)),...L_(h.sightings(d)),...I_(l.refusals)];o.draw(y,m,d)}),h=new Qh(i,c),u=(d,m)=>i.follow(d,y=>{l[m]=y,c()});return u("(goal ?n ?facts)","goals"),u("(goal-state ?n ?state ?detail)","states"),u("(board-refusal ?client ?symbol ?count ?sentence)","refusals"),a.addEventListener("change",c),new ResizeObserver(c).observe(o.panel),setInterval(c,nA),{panel:R("section",{"aria-label":"Over time"},R("div",{class:"row"},R("h2",{},"Over time"),R("label",{},"The last ",a)),o.panel,n),draw:c}}var B_="(event ?n ?kind ?sentence ?detail)",Nd=5e3,tr=i=>i.facts[0].when,Ka=i=>`${dt(i)[1]}@${tr(i)}`,nu=class{#t;#e=new Map;#n=!1;#i=!1;#s=[];constructor(t){this.#t=t,t.follow(B_,e=>{this.#o(e),this.#r()})}onChange(t){this.#s.push(t)}#r(){for(let t of this.#s)t()}until(t){return[...this.#e.values()].filter(n=>tr(n)<=t).sort((n,s)=>tr(n)-tr(s)||dt(n)[1]-dt(s)[1])}async reach(t){if(!(this.#n||this.#i)){for(this.#n=!0;!this.#i&&this.#e.size<Nd;){let e=this.until(1/0)[0];if(!e||dt(e)[1]<=1||tr(e)<=t)break;let n=this.#e.size;this.#o(await this.#t.askThen(B_,tr(e)).catch(()=>[])),this.#i=this.#e.size===n,this.#r()}this.#n=!1}}#o(t){for(let n of t)this.#e.set(Ka(n),n);if(this.#e.size<=Nd)return;let e=[...this.#e].sort(([,n],[,s])=>tr(n)-tr(s)).slice(0,this.#e.size-Nd);for(let[n]of e)this.#e.delete(n)}};var iA=200;function sA(i,t,e){let n=i.map(dt).filter(a=>a[1]<t),s=n.filter(a=>or(a[4])?.goal===e).toSorted((a,l)=>l[1]-a[1])[0],r=s&&or(s[4]);if(!r)return null;let o=n.filter(a=>a[1]>s[1]&&J(a[2])==="operation").map(a=>we(a[4]));return{operations:r.operations,begun:new Set(o)}}function rA(i,t,e){let n=or(e),s=n&&sA(i,t,n.goal);return s?Bp(s.operations,n.operations,s.begun):R("pre",{},Jt(we(e),4e3))}function oA({connection:i,images:t,goTo:e},n,s){let[,r,o,a,l]=dt(s),c=s.facts[0],h=R("summary",{},R("time",{},tn(c.when)),R("span",{class:`kind ${J(o)}`},J(o)),R("span",{},Jt(J(a)))),u=R("div",{});return R("details",{"data-number":r,ontoggle:d=>d.target.open&&u.replaceChildren(C_(i,t.telling(),c.when))},h,R("p",{class:"quiet"},Vr(s.ids[0],c)),R("button",{type:"button",class:"small",onclick:()=>e(c.when)},"Show all as it was then"),u,Ep(i,s.ids[0],c),rA(n,r,l))}function k_(i,t,e,n){let s=R("div",{class:"timeline"}),r=R("pre",{class:"answer",hidden:!0}),o=async()=>{r.hidden=!1;try{r.textContent=(await i.request("coordinator","(why)")).map(d=>Jt(d,1e3)).join(`
`)}catch(d){r.textContent=Te(d)}},a=()=>t.until(i.moment??1/0),l=d=>oA({connection:i,images:e,goTo:n},a(),d),c=O_(i,t,l);Rt("story").append(R("div",{class:"row"},R("button",{type:"button",id:"why",onclick:o},"Why this, now?")),r,c.panel,A_(i),s);let h=new Map,u=d=>{let m=h.get(Ka(d))??l(d);return h.set(Ka(d),m),m},f=ii(()=>{let d=a().reverse().slice(0,iA),m=new Set(d.map(Ka));for(let y of h.keys())m.has(y)||h.delete(y);dl(s,d.map(u)),c.draw()});t.onChange(f)}var aA={ArrowRight:1,ArrowLeft:-1};function z_(){let i=[...document.querySelectorAll("[role=tab]")].filter(e=>e instanceof HTMLElement),t=e=>{for(let n of i)n.setAttribute("aria-selected",String(n===e)),n.tabIndex=n===e?0:-1,Rt(n.getAttribute("aria-controls")??"").hidden=n!==e};for(let e of i)e.addEventListener("click",()=>t(e)),e.addEventListener("keydown",n=>{let s=aA[n.key];if(!s)return;let r=i.filter(a=>!a.hidden),o=r[(r.indexOf(e)+s+r.length)%r.length];t(o),o.focus()});t(i[0])}var lA=12;function V_(i,t){let e=R("ul",{id:`${i.id}-words`,class:"words",role:"listbox","aria-label":"What may come next",hidden:!0});i.after(e);for(let[u,f]of Object.entries({role:"combobox","aria-autocomplete":"list","aria-expanded":"false","aria-controls":e.id}))i.setAttribute(u,f);let n={from:0,words:[]},s=-1,r=()=>i.selectionStart??0,o=u=>{if(s=u,[...e.children].forEach((f,d)=>f.setAttribute("aria-selected",String(d===s))),s<0)return i.removeAttribute("aria-activedescendant");i.setAttribute("aria-activedescendant",e.children[s].id),e.children[s].scrollIntoView({block:"nearest"})},a=()=>{e.hidden=!0,o(-1),i.setAttribute("aria-expanded","false")},l=u=>{let f=r();i.setRangeText(n.words[u].put,n.from,f,"end"),i.dispatchEvent(new Event("input",{bubbles:!0}))},c=()=>{n=t(i.value.slice(0,r()));let u=n.words.slice(0,lA).map(({word:f},d)=>{let m=R("li",{role:"option",id:`${e.id}-${d}`,"aria-selected":"false"},f);return m.addEventListener("pointerdown",y=>{y.preventDefault(),l(d)}),m});if(e.replaceChildren(...u),u.length===0)return a();e.hidden=!1,i.setAttribute("aria-expanded","true"),o(-1)},h=()=>r()>n.from;i.addEventListener("input",c),i.addEventListener("blur",a),i.addEventListener("keydown",u=>{let f=e.children.length;e.hidden?u.key==="ArrowDown"&&c():u.key==="ArrowDown"||u.key==="ArrowUp"?(u.preventDefault(),o((s+(u.key==="ArrowDown"?1:s<0?0:-1)+f)%f)):u.key==="Enter"&&s>=0||u.key==="Tab"&&!u.shiftKey&&(s>=0||h())?(u.preventDefault(),l(Math.max(s,0))):(u.key==="Enter"||u.key==="Escape")&&a()})}var G_=["and","or","not","then","keep"];function cA(i){let t=[];for(let[r]of i.matchAll(/[()]|[^\s()]+/g))r==="("?t.push([]):r===")"?(t.pop(),t.at(-1)?.push("()")):t.at(-1)?.push(r);let e=t.at(-1);if(!e)return null;let[n="",...s]=e;return{head:n,rest:s}}function H_(i,{predicates:t,names:e}){let n=i.match(/[^\s()]*$/)?.[0]??"",s=i.slice(0,i.length-n.length),r=cA(s),o=[...t.keys(),...G_],a=(f,d)=>f.filter(m=>m!==n&&m.startsWith(n.toLowerCase())).map(m=>({word:m,put:d(m)})),l=f=>({from:s.length,words:f});if(!r&&n===""&&s.trim()!=="")return l([]);if(!r||G_.includes(r.head))return l(a(o,f=>`(${f} `));if(r.head==="")return l(a(o,f=>`${f}${t.get(f)===0?")":" "}`));let c=t.get(r.head.toLowerCase());if(c===void 0)return l(a(e,f=>`${f} `));let h=c-r.rest.length;if(h<=0)return l([]);let u=e.filter(f=>!r.rest.includes(f));return l(a(u,f=>`${f}${h===1?")":" "}`))}var W_="the table",hA=16,Ud=class{#t=[];#e=new Map;#n="";#i="";#s=R("div",{class:"towers",role:"group","aria-label":"Towers"});panel=R("div",{id:"sketch",hidden:!0});constructor(t){this.written=t;let e=R("button",{type:"button",onclick:()=>this.#c()},"Clear");this.panel.append(this.#s,R("div",{class:"row"},R("span",{class:"quiet"},"Drag a block onto another."),e)),this.#s.addEventListener("pointerup",n=>this.#u(n)),this.#s.addEventListener("pointercancel",()=>this.#i="")}setNames(t){this.#t=t.slice(0,hA);for(let[e,n]of this.#e)(!this.#t.includes(e)||!this.#t.includes(n))&&this.#e.delete(e);this.#h()}#r(t){return[...this.#e].find(([,e])=>e===t)?.[0]}#o(t){let e=this.#r(t);return e?[t,...this.#o(e)]:[t]}#a(t,e){if(this.#n="",e===W_)this.#e.delete(t);else if(t!==e&&!this.#o(t).includes(e)){let n=this.#l(e);this.#e.delete(t),this.#e.set(t,this.#o(n).at(-1)??n)}this.#h(),this.written(this.#t.flatMap(n=>this.#e.has(n)?[`(on ${n} ${this.#e.get(n)})`]:[]).join(" "))}#l(t){let e=this.#e.get(t);return e===void 0?t:this.#l(e)}#c(){this.#e.clear(),this.#n="",this.#h(),this.written("")}#u(t){let e=this.#i;if(this.#i="",!e)return;let n=document.elementFromPoint(t.clientX,t.clientY)?.closest("[data-block], .towers"),s=n&&(n.getAttribute("data-block")??W_);s&&s!==e&&this.#a(e,s)}#f(t){if(this.#n&&this.#n!==t)return this.#a(this.#n,t);this.#n=this.#n?"":t,this.#h()}#d(t){let e=R("button",{type:"button",class:"block","data-block":t,"aria-pressed":String(t===this.#n)},Jt(t,20));return e.addEventListener("pointerdown",n=>{this.#i=t,e.releasePointerCapture?.(n.pointerId)}),e.addEventListener("click",()=>this.#f(t)),e}#h(){let t=this.#t.filter(e=>!this.#e.has(e));this.#s.replaceChildren(...t.map(e=>R("div",{class:"tower"},...this.#o(e).toReversed().map(n=>this.#d(n)))))}};function X_(){let i=new Ud(n=>Rt("goal-text").value=n),t=R("button",{type:"button",id:"sketch-toggle","aria-expanded":"false","aria-controls":"sketch"},"Sketch"),e=n=>{i.panel.hidden=!n,t.setAttribute("aria-expanded",String(n))};return t.addEventListener("click",()=>e(!!i.panel.hidden)),Rt("goal-form").addEventListener("submit",()=>e(!1)),Rt("cancel").before(t),Rt("goal-answer").before(i.panel),i}var uA="end-effector";function fA(i,t){let e=Number(t.place?.match(/^goal:1:(\d+)/)?.[1]??0);if(i.setAttribute("aria-invalid","true"),e===0)return;let n=i.value.slice(e-1).match(/^[()]|^[^\s()]+/)?.[0]??" ";i.focus(),i.setSelectionRange(e-1,e-1+n.length)}function dA(i){let t=new Map;for(let[,,e]of i.map(dt)){let n=r=>e.filter(o=>J(o[0])===r).flatMap(o=>o.slice(1));if(!n("offers").some(r=>J(r[0])==="goal"))continue;let s=new Set(n("reads").map(J));for(let[,r,o,...a]of n("posts"))s.has(J(r))&&o.every(([,c])=>J(c)==="symbol")&&!a.some(c=>J(c[0])==="durable")&&t.set(J(r),o.length)}return t}function q_(i){let t=X_(),e=Rt("goal-answer"),n=Rt("goal-text"),s=(c,h="")=>{e.hidden=!1,e.className=h,e.textContent=c},r=async c=>{s("asking \u2026"),n.removeAttribute("aria-invalid");try{let[h]=await i.goal(c,u=>{"error"in u?s(Te(u.error),"bad"):s(`goal ${h} ${u.values[0]}`,u.values[0]==="reached"?"good":"")});s(`goal ${h} accepted`)}catch(h){s(Te(h),"bad"),fA(n,h)}};Rt("goal-form").addEventListener("submit",c=>{c.preventDefault(),r(n.value)}),Rt("cancel").addEventListener("click",async()=>{try{await i.request("coordinator","(cancel)")}catch(c){s(Te(c),"bad")}}),i.follow("(goal-state ?n ?state ?detail)",c=>{let h=c.map(dt).toSorted((d,m)=>m[1]-d[1])[0],u=Rt("goal-chip");if(u.hidden=!h,!h)return;let f=J(h[2]);u.textContent=`goal ${h[1]}: ${f}`,u.className=`chip ${f==="reached"?"good":f==="running"?"busy":"warn"}`,Rt("cancel").disabled=f!=="running"});let o=[],a=[],l=new Map;i.follow("(contract ?name ?form)",c=>l=dA(c)),i.follow("(believed ?fact)",c=>a=c.flatMap(h=>dt(h)[1].slice(1).map(J))),i.follow("(learned ?eyes ?name 1 ? ? ? ? ? ?)",c=>{o=c.map(h=>J(dt(h)[2])).filter(h=>h!==uA),t.setNames([...new Set(o)].slice(0,12))}),V_(n,c=>H_(c,{predicates:l,names:[...new Set([...o,...a])].sort()}))}var en=new fl,Hi=new ml(en),ja=new yl(en);z_();var pA=Dp(en),mA=Fp(Hi);E_(en,Hi);Pp(Hi);var $_=Kg(en,ja),iu=Up(en,ja),Y_=new nu(en);q_(en);zp(en,Y_);w_(en);k_(en,Y_,iu,Op(en,iu));Lp(en,iu,()=>Hi.me);wp(en,iu,ja,()=>Hi.me);vp(en,Hi);var Z_=new il(en);Rp(en,Z_);dp(en,Z_);gp(en);en.onArm=$_.moveArm;en.onHello=i=>{Rt("cell").textContent=i.cell,Hi.me=i.name,Hi.changed(),$_.setCell(i)};ja.onChange(()=>{Hi.robot=ja.server("robot")||Hi.robot,Hi.changed()});en.onState=(i,t)=>{mA(i,t),pA(i)};en.open();
